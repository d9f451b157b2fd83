// loses: ColumnAtRest; misconception: column_own_weight
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n);
  if (depth > 0) return std::max(0.0, k * depth - d * v.dot(n)) * n;
  return Vec3::Zero();
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = (x - c).norm();
  if (r > 0 && r < R) {
    const Vec3 n = (x - c) / r;
    return std::max(0.0, k * (R - r) - d * v.dot(n)) * n;
  }
  return Vec3::Zero();
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double total = 0;
  for (double mass : m) total += mass;
  std::vector<double> z(m.size());
  z[0] = -total * g / kPlane;
  for (std::size_t i = 1; i < m.size(); ++i) z[i] = z[i - 1] + L0 - m[i] * g / k;
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double s = t.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) * (t / s);
}
