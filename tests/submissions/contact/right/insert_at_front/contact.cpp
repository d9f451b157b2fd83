#include "contact.h"

static Vec3 nothing() { return Vec3(0, 0, 0); }

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  auto depth = (p - x).dot(n);
  if (depth <= 0) return nothing();
  auto spring = k * depth;
  auto damper = d * v.dot(n);
  if (damper >= spring) return nothing();
  return (spring - damper) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 n = x - c;
  if (n.x() == 0 && n.y() == 0 && n.z() == 0) return nothing();
  double dist = std::hypot(n.x(), n.y(), n.z());
  n /= dist;
  auto depth = R - dist;
  if (depth <= 0) return nothing();
  auto spring = k * depth;
  auto damper = d * v.dot(n);
  if (damper >= spring) return nothing();
  return (spring - damper) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  // the top is cut off first: what is above a cut is carried by what is below it
  std::vector<double> parts;
  double load = 0;
  for (std::size_t i = m.size(); i > 0; --i) {
    load += m[i - 1] * g;
    parts.insert(parts.begin(), i > 1 ? L0 - load / k : -load / kPlane);
  }
  std::vector<double> z;
  for (double part : parts) z.push_back(z.empty() ? part : part + z.back());
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 vt = v - v.dot(n) * n;
  double speed = vt.stableNorm();
  if (speed == 0) return nothing();
  double size = (c * speed < mu * N) ? c * speed : mu * N;
  return -size * (vt / speed);
}
