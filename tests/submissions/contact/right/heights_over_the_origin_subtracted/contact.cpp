// p.n - x.n: equal in algebra
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double planeHeight = p.dot(n);
  const double nodeHeight = x.dot(n);
  const double depth = planeHeight - nodeHeight;
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = (x - c).norm();
  if (r == 0 || r >= R) return Vec3::Zero();
  const Vec3 n = (x - c) / r;
  return std::max(0.0, k * (R - r) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double load = 0;
  for (double mass : m) load += mass * g;
  std::vector<double> z;
  double height = -load / kPlane;
  for (double mass : m) {
    z.push_back(height);
    load -= mass * g;
    height += L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double s = t.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) / s * t;
}
