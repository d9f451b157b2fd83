#include "contact.h"

// std::fdim(a, b) is a - b, but never negative.

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = std::fdim(0.0, (x - p).dot(n));
  if (depth == 0.0) return Vec3::Zero();
  return n * std::fdim(k * depth, d * v.dot(n));
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  const double depth = std::fdim(R, dist);
  if (depth == 0.0 || dist == 0.0) return Vec3::Zero();
  return (r / dist) * std::fdim(k * depth, d * v.dot(r / dist));
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const auto count = m.size();
  std::vector<double> z(count, 0.0);
  // every node presses the plane and all the springs below it
  for (std::size_t j = 0; j < count; ++j) {
    const double w = m[j] * g;
    for (std::size_t i = 0; i < count; ++i) {
      z[i] -= w / kPlane;
      z[i] -= static_cast<double>(std::min(i, j)) * w / k;
    }
  }
  for (std::size_t i = 0; i < count; ++i) z[i] += static_cast<double>(i) * L0;
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double speed = std::hypot(t.x(), t.y(), t.z());
  double factor = c;
  if (c * speed > mu * N) factor = mu * N / speed;
  return -factor * t;
}
