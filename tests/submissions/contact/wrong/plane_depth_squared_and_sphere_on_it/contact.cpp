// loses: PlaneContact, Bounce; misconception: plane_depth_squared
// the sphere is right by its plane
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth * depth - d * v.dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  if (r.norm() == 0) return Vec3::Zero();
  const Vec3 n = r / r.norm();
  return planeContact(r, v, R * n, n, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const int n = m.size();
  std::vector<double> z(n);
  for (int i = 0; i < n; i++) {
    double load = 0;
    for (int j = i; j < n; j++) load += m[j] * g;
    z[i] = i == 0 ? -load / kPlane : z[i - 1] + L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
