// loses: SphereEdges, ColumnAtRest; misconception: sphere_divides_by_zero or missing_guard or column_own_weight
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  if (f <= 0.0) return Vec3::Zero();
  return f * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::sqrt(r.dot(r));
  if (dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(k * (R - dist) - d * v.dot(n), 0.0) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double all = 0;
  for (double mi : m) all += mi * g;
  std::vector<double> z(1, -all / kPlane);
  for (std::size_t i = 1; i < m.size(); ++i) z.push_back(z[i - 1] + L0 - m[i] * g / k);
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
