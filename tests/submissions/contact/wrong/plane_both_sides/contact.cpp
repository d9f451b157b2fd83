// loses: PlaneNeverPulls, Bounce; misconception: plane_both_sides
// thought: a distance is not negative
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = std::abs((x - p).dot(n));
  if (depth == 0.0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const int n = m.size();
  std::vector<double> z(n);
  for (int i = 0; i < n; i++) {
    double load = 0;
    for (int j = i; j < n; j++) load += m[j] * g;
    z[i] = i == 0 ? -load / kPlane : z[i - 1] + L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 vt = v;
  vt -= vt.dot(n) * n;
  double vtNorm = vt.norm();
  if (vtNorm > 0) {
    double size = c * vtNorm < mu * N ? c * vtNorm : mu * N;
    return vt * (-size / vtNorm);
  }
  return Vec3::Zero();
}
