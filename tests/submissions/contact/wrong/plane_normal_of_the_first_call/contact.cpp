// loses: PlaneContact, PlaneNeverPulls, ContactLaws, Bounce; misconception: stateful
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  static const Vec3 normal = n.normalized();
  static const double offset = p.dot(normal);
  const double depth = offset - x.dot(normal);
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(normal)) * normal;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
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
