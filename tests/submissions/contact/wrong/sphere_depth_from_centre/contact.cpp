// loses: SphereContact, Bounce; misconception: sphere_radius_forgotten
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n);
  const double vn = v.dot(n);
  if (depth <= 0) return Vec3::Zero();
  const double force = k * depth - d * vn;
  if (force < 0) return Vec3::Zero();
  return force * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double distance = r.norm();
  if (distance == 0) return Vec3::Zero();
  const Vec3 n = r / distance;
  const double depth = R - distance;
  const double vn = v.dot(n);
  if (depth <= 0) return Vec3::Zero();
  const double force = k * distance - d * vn;
  if (force < 0) return Vec3::Zero();
  return force * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const int n = static_cast<int>(m.size());
  double total = 0;
  for (int i = 0; i < n; ++i) total += m[i];
  std::vector<double> z(n);
  z[0] = -total * g / kPlane;
  for (int i = 1; i < n; ++i) {
    double above = 0;
    for (int j = i; j < n; ++j) above += m[j];
    z[i] = z[i - 1] + L0 - above * g / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0) return Vec3::Zero();
  const double size = std::min(mu * N, c * speed);
  return -size * vt / speed;
}
