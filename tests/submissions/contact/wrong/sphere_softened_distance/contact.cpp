// loses: SphereContact, SphereEdges; misconception: softened_length
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double inside = n.dot(p - x);
  return inside > 0 ? Vec3(std::max(k * inside - d * n.dot(v), 0.0) * n) : Vec3(0, 0, 0);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = r.norm();
  const double depth = R - dist;
  if (depth <= 0.0) return Vec3::Zero();
  const Vec3 n = r / (dist + 1e-14);
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
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
