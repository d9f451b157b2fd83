// loses: Friction; misconception: friction_total_velocity
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  const double size = k * depth - d * v.dot(n);
  return depth > 0 && size > 0 ? Vec3(size * n) : Vec3(0, 0, 0);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = (x - c).norm();
  if (r == 0) return Vec3(0, 0, 0);
  const Vec3 n = (x - c) / r;
  const double size = k * (R - r) - d * v.dot(n);
  return r < R && size > 0 ? Vec3(size * n) : Vec3(0, 0, 0);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double load = 0;
  for (double mass : m) load += mass * g;
  std::vector<double> z(m.size());
  double height = -load / kPlane;
  for (std::size_t i = 0; i < m.size(); ++i) {
    z[i] = height;
    load -= m[i] * g;
    height += L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  (void)n;
  const double speed = v.norm();
  if (speed == 0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * v / speed;
}
