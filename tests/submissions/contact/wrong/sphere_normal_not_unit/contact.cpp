// loses: SphereContact, Bounce; misconception: sphere_not_normalised
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 n = x - c;
  const double depth = R - n.norm();
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  double load = 0;
  for (std::size_t i = m.size(); i-- > 0;) {
    load += m[i] * g;
    z[i] = i == 0 ? -load / kPlane : L0 - load / k;  // lengths first
  }
  for (std::size_t i = 1; i < z.size(); ++i) z[i] += z[i - 1];
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double s = vt.norm();
  return s > 0 ? Vec3(-std::min(mu * N, c * s) * vt / s) : Vec3(0, 0, 0);
}
