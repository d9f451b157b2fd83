#include "contact.h"

namespace {

/// The length of a vector, also where the squares of its components vanish.
double length(const Vec3& a) {
  const double usual = a.norm();
  return usual > 1e-140 ? usual : a.stableNorm();
}

}  // namespace

namespace {

Vec3 penalty(const Vec3& outward, double depth, double leaving, double stiffness, double damping) {
  if (!(depth > 0.0)) return Vec3::Zero();
  const double size = stiffness * depth - damping * leaving;
  if (size < 0.0) return Vec3::Zero();
  return size * outward;
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return penalty(n, (p - x).dot(n), v.dot(n), k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = length(r);
  if (dist == 0.0) return Vec3::Zero();
  const Vec3 n = r / dist;
  return penalty(n, R - dist, v.dot(n), k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const std::size_t n = m.size();
  // carried[i]: mass of node i and of all the nodes above
  std::vector<double> carried(n);
  double above = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    above += m[i];
    carried[i] = above;
  }
  std::vector<double> z(n);
  z[0] = -carried[0] * g / kPlane;
  for (std::size_t i = 1; i < n; ++i) z[i] = z[i - 1] + L0 - carried[i] * g / k;
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - n * n.dot(v);
  const double s = vt.stableNorm();
  if (c * s <= mu * N) return -c * vt;
  return -mu * N * (vt / s);
}
