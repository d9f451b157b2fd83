// loses: ColumnAtRest; misconception: column_top_forgotten
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double inside = n.dot(p - x);
  return inside > 0 ? Vec3(std::max(k * inside - d * n.dot(v), 0.0) * n) : Vec3(0, 0, 0);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  for (std::size_t i = 0; i < m.size(); i++) {
    double load = 0;
    for (std::size_t j = i; j + 1 < m.size(); j++) load += m[j] * g;
    if (i == 0)
      z[i] = -load / kPlane;
    else
      z[i] = z[i - 1] + L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
