// loses: SphereEdges; misconception: sphere_divides_by_zero or missing_guard
#include "contact.h"

static Vec3 force(double depth, const Vec3& v, const Vec3& n, double k, double d) {
  if (depth <= 0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  if (f <= 0) return Vec3::Zero();
  return f * n;
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return force(-(x - p).dot(n), v, n, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = (x - c).norm();
  return force(R - r, v, (x - c) / r, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double load = 0;
  for (double mass : m) load += mass * g;
  std::vector<double> z = {-load / kPlane};
  for (std::size_t i = 0; i + 1 < m.size(); ++i) {
    load -= m[i] * g;
    z.push_back(z[i] + L0 - load / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double s = t.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) * (t / s);
}
