// loses: PlaneContact, Bounce; misconception: energy_for_force
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  const double spring = k * depth * depth / 2;
  const double damper = d * v.dot(n);
  return std::max(0.0, spring - damper) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dist = std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]);
  if (dist == 0) return Vec3::Zero();
  Vec3 n = (x - c) / dist;
  double delta = R - dist;
  if (delta <= 0) return Vec3::Zero();
  double f = k * delta - d * v.dot(n);
  if (f < 0) f = 0;
  return f * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double above = 0.0;
  for (double mi : m) above += mi;
  std::vector<double> z;
  z.push_back(-above * g / kPlane);
  for (std::size_t i = 1; i < m.size(); ++i) {
    above -= m[i - 1];
    z.push_back(z.back() + L0 - above * g / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
