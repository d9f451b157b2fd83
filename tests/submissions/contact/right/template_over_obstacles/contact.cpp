#include "contact.h"

#include <numeric>
#include <utility>

namespace {

template <typename DepthAndNormal>
Vec3 contact(const DepthAndNormal& obstacle, const Vec3& v, double k, double d) {
  const std::pair<double, Vec3> hit = obstacle();
  const double f = k * hit.first - d * v.dot(hit.second);
  return (hit.first > 0.0 && f > 0.0) ? Vec3(f * hit.second) : Vec3(0.0, 0.0, 0.0);
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return contact([&] { return std::make_pair((p - x).dot(n), n); }, v, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist > 0.0) return contact([&] { return std::pair<double, Vec3>(R - dist, r / dist); }, v, k, d);
  return Vec3::Zero();
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> load(m.size());
  std::partial_sum(m.rbegin(), m.rend(), load.rbegin());
  std::vector<double> gaps(m.size());
  std::transform(load.begin(), load.end(), gaps.begin(), [&](double M) { return L0 - M * g / k; });
  gaps[0] = -load[0] * g / kPlane;
  std::partial_sum(gaps.begin(), gaps.end(), gaps.begin());
  return gaps;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double viscous = c * t.stableNorm();
  const double limit = mu * N;
  if (viscous > limit) return t.stableNormalized() * -limit;
  return t * -c;
}
