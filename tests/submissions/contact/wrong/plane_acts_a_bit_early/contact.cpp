// loses: PlaneNeverPulls; misconception: plane_damps_outside
// thought: a tolerance for rounding
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth < -1e-6) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
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
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
