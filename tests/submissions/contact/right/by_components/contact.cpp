#include "contact.h"

static double dot(const Vec3& a, const Vec3& b) { return a(0) * b(0) + a(1) * b(1) + a(2) * b(2); }

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  Vec3 force(0, 0, 0);
  double depth = -dot(x - p, n);
  if (depth > 0) {
    double size = k * depth - d * dot(v, n);
    if (size > 0)
      for (int i = 0; i < 3; ++i) force(i) = size * n(i);
  }
  return force;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 force(0, 0, 0);
  Vec3 r = x - c;
  double distance = std::sqrt(dot(r, r));
  if (distance > 0 && distance < R) {
    double size = k * (R - distance) - d * dot(v, r) / distance;
    if (size > 0)
      for (int i = 0; i < 3; ++i) force(i) = size * r(i) / distance;
  }
  return force;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> above = m;  // mass at and above each node
  for (int i = static_cast<int>(m.size()) - 2; i >= 0; --i) above[i] += above[i + 1];
  std::vector<double> z = {-above[0] * g / kPlane};
  while (z.size() < m.size()) z.push_back(z.back() + L0 - above[z.size()] * g / k);
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  double vn = dot(v, n);
  Vec3 vt(v(0) - vn * n(0), v(1) - vn * n(1), v(2) - vn * n(2));
  double speed = std::sqrt(dot(vt, vt));
  if (speed > 0) {
    double size = mu * N < c * speed ? mu * N : c * speed;
    for (int i = 0; i < 3; ++i) vt(i) *= -size / speed;
  }
  return vt;
}
