#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -((x[0] - p[0]) * n[0] + (x[1] - p[1]) * n[1] + (x[2] - p[2]) * n[2]);
  const bool touching = depth > 0;
  const double f = touching * std::max(0.0, k * depth - d * v.dot(n));
  return f * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double biggest = r.cwiseAbs().maxCoeff();
  if (biggest == 0) return Vec3::Zero();
  // scaled, so that the squares neither vanish nor overflow
  const double dist = biggest * (r / biggest).norm();
  const Vec3 n = (r / biggest).normalized();
  const bool touching = R > dist;
  return touching * std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m);
  double above = 0;
  for (auto i = static_cast<std::ptrdiff_t>(m.size()) - 1; i >= 0; --i) {
    above += m[i];
    z[i] = i == 0 ? -above * g / kPlane : L0 - above * g / k;
  }
  for (std::size_t i = 1; i < z.size(); ++i) z[i] += z[i - 1];
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - n * v.dot(n);
  const double scale = t.cwiseAbs().maxCoeff();
  if (scale == 0) return Vec3::Zero();
  const Vec3 e = (t / scale).normalized();
  return -std::min(mu * N, c * t.dot(e)) * e;
}
