#include "contact.h"
#include <cmath>
Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = p[0] * n[0] + p[1] * n[1] + p[2] * n[2] - x[0] * n[0] - x[1] * n[1] - x[2] * n[2];
  if (!(depth > 0)) return {0, 0, 0};
  return std::fmax(k * depth - d * n.dot(v), 0.0) * n;
}
Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double L = std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]);
  if (L == 0 || L >= R) return {0, 0, 0};
  const Vec3 n((x[0] - c[0]) / L, (x[1] - c[1]) / L, (x[2] - c[2]) / L);
  return std::fmax(k * (R - L) - d * n.dot(v), 0.0) * n;
}
std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  for (std::size_t i = 0; i < m.size(); ++i) {
    double above = 0;
    for (std::size_t j = m.size(); j-- > i;) above += m[j];
    z[i] = i == 0 ? -above * g / kPlane : z[i - 1] + (L0 - above * g / k);
  }
  return z;
}
Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - n * n.dot(v);
  const double s = std::hypot(t[0], t[1], t[2]);
  if (s == 0) return Vec3::Zero();
  if (c * s < mu * N) return -c * t;
  return -mu * N / s * t;
}
