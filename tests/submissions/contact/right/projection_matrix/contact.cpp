#include "contact.h"

using muelle::Mat3;

namespace {

Mat3 along(const Vec3& n) { return n * n.transpose(); }
Mat3 across(const Vec3& n) { return Mat3::Identity() - along(n); }

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = n.dot(p - x);
  if (depth <= 0.0) return Vec3::Zero();
  const Vec3 f = k * depth * n - d * (along(n) * v);
  if (f.dot(n) <= 0.0) return Vec3::Zero();
  return f;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 out = x - c;
  double dist = out.norm();
  if (dist < 1e-120) dist = out.stableNorm();  // the squares vanish before the vector does
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = out / dist;
  const Vec3 f = k * (R - dist) * n - d * (along(n) * v);
  if (f.dot(n) <= 0.0) return Vec3::Zero();
  return f;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const Eigen::Map<const muelle::VecX> mass(m.data(), static_cast<Eigen::Index>(m.size()));
  std::vector<double> z(m.size());
  z[0] = -mass.sum() * g / kPlane;
  for (std::size_t i = 1; i < m.size(); ++i) {
    const double above = mass.tail(static_cast<Eigen::Index>(m.size() - i)).sum();
    z[i] = z[i - 1] + L0 - above * g / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = across(n) * v;
  const double speed = vt.stableNorm();
  if (speed > 0.0) return -(std::min(c * speed, N * mu) / speed) * vt;
  return Vec3::Zero();
}
