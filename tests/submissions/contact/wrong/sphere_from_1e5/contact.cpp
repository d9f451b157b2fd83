// loses: SphereEdges; misconception: sphere_shallow
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  return std::max(0.0, f) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double distance = (x - c).norm();
  if (distance == 0) return Vec3::Zero();
  const Vec3 n = (x - c) / distance;
  const double depth = R - distance;
  if (depth < 1e-5) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  return std::max(0.0, f) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const std::size_t n = m.size();
  double load = 0.0;
  for (std::size_t i = 0; i < n; ++i) load += m[i] * g;
  std::vector<double> z(n);
  z[0] = -load / kPlane;
  for (std::size_t i = 1; i < n; ++i) {
    load -= m[i - 1] * g;
    z[i] = z[i - 1] + L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double speed = t.norm();
  if (speed == 0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * t / speed;
}
