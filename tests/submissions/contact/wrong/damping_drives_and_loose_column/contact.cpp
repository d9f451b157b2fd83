// loses: PlaneContact, ContactLaws, Bounce, ColumnAtRest; misconception: plane_damping_sign or column_rest_lengths
// two mistakes: k depth + d v_n for the plane, and springs at their rest length in the column
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n);
  const double vn = v.dot(n);
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth + d * vn) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = r.norm();
  const double depth = R - dist;
  if (dist == 0 || depth <= 0) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  (void)k;
  double total = 0;
  for (double mass : m) total += mass;
  std::vector<double> z(m.size());
  for (std::size_t i = 0; i < m.size(); ++i) z[i] = -total * g / kPlane + i * L0;
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  if (vt.norm() == 0) return Vec3::Zero();
  return -std::min(mu * N, c * vt.norm()) * vt / vt.norm();
}
