// loses: SphereContact, SphereEdges, ContactLaws, Bounce; misconception: zero
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double delta = (p - x).dot(n);
  double vn = v.dot(n);
  Vec3 F(0, 0, 0);
  if (delta > 0) {
    F = std::max(0.0, k * delta - d * vn) * n;
  }
  return F;
}

Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) {
  return Vec3::Zero();
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
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
