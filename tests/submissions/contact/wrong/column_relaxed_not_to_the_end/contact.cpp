// loses: ColumnAtRest; misconception: difference_quotient
// thought: move every node until it does not move any more; a thousand rounds are plenty
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  if (f <= 0.0) return Vec3::Zero();
  return f * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const std::size_t n = m.size();
  std::vector<double> z(n);
  for (std::size_t i = 0; i < n; ++i) z[i] = i * L0;
  for (int round = 0; round < 1000; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      double stiffness = 0.0;
      double pull = -m[i] * g;
      if (i == 0) {
        stiffness += kPlane;
      } else {
        stiffness += k;
        pull += k * (z[i - 1] + L0);
      }
      if (i + 1 < n) {
        stiffness += k;
        pull += k * (z[i + 1] - L0);
      }
      z[i] = pull / stiffness;
    }
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
