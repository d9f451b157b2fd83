// loses: Friction, FrictionMotion; misconception: friction_not_normalised
// thought: vt gives the direction
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  if (f <= 0.0) return Vec3::Zero();
  return f * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 n = x - c;
  const double distance = std::hypot(n.x(), n.y(), n.z());
  const double depth = R - distance;
  if (!(depth > 0) || !(distance > 0)) return Vec3(0, 0, 0);
  n /= distance;
  const double push = k * depth - d * n.dot(v);
  return push > 0 ? Vec3(push * n) : Vec3(0, 0, 0);
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
  const Vec3 vt = v - v.dot(n) * n;
  return -std::min(mu * N, c * vt.norm()) * vt;
}
