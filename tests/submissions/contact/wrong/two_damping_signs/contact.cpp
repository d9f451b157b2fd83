// loses: PlaneContact, SphereContact, ContactLaws, Bounce; misconception: plane_damping_sign or sphere_damping_sign
// one helper, both wrong
#include "contact.h"

static double respond(double depth, double speed, double k, double d) {
  if (depth <= 0) return 0;
  return std::max(0.0, k * depth + d * speed);
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return respond(-(x - p).dot(n), v.dot(n), k, d) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double dist = (x - c).norm();
  if (dist == 0) return Vec3::Zero();
  const Vec3 n = (x - c) / dist;
  return respond(R - dist, v.dot(n), k, d) * n;
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
