#include "contact.h"

// Size of the force of an obstacle, never negative.
static double push(double depth, double vn, double k, double d) {
  if (depth <= 0) return 0;
  double size = k * depth - d * vn;
  return size > 0 ? size : 0;
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return push((p - x).dot(n), v.dot(n), k, d) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 out = x - c;
  double r = out.norm();
  if (r == 0) return Vec3::Zero();
  out /= r;
  return push(R - r, v.dot(out), k, d) * out;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const std::size_t n = m.size();
  std::vector<double> above(n + 1, 0.0);  // above[i]: mass of the nodes i, i + 1, ...
  for (std::size_t i = n; i-- > 0;) above[i] = above[i + 1] + m[i];
  std::vector<double> z(n);
  z[0] = -above[0] * g / kPlane;
  for (std::size_t i = 1; i < n; ++i) z[i] = z[i - 1] + L0 - above[i] * g / k;
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 vt = v - n * n.dot(v);
  double speed = vt.norm();
  if (speed == 0) return Vec3::Zero();
  Vec3 dir = vt / speed;
  return -std::min(mu * N, c * speed) * dir;
}
