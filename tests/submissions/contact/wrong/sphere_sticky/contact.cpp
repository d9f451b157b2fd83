// loses: SphereEdges, Bounce; misconception: sphere_pulls
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double delta = (p - x).dot(n);
  double vn = v.dot(n);
  Vec3 F(0, 0, 0);
  if (delta > 0) {
    F = std::max(0.0, k * delta - d * vn) * n;
  }
  return F;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dist = (x - c).norm();
  if (dist >= R) return Vec3::Zero();
  if (dist == 0) return Vec3::Zero();
  Vec3 n = (x - c) / dist;
  Vec3 elastic = k * (R - dist) * n;
  Vec3 viscous = -d * n.dot(v) * n;
  return elastic + viscous;
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
