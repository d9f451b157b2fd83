#include "contact.h"

// A sphere is, for one node, the plane that touches it where the node would come out.

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double height = n.dot(x - p);
  if (height >= 0) return Vec3::Zero();
  return std::max(-k * height - d * n.dot(v), 0.0) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  if (r.isZero(0.0)) return Vec3::Zero();
  const Vec3 n = r.stableNormalized();
  return planeContact(r, v, R * n, n, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double M = 0;
  for (double mi : m) M += mi;
  std::vector<double> z(1, -M * g / kPlane);
  for (std::size_t i = 0; i + 1 < m.size(); ++i) {
    M -= m[i];
    z.push_back(z.back() + L0 - M * g / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  return -std::min(mu * N, c * t.stableNorm()) * t.stableNormalized();
}
