#include "contact.h"

// The sphere is its tangent plane below the node; the column is built from the top down.

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double gap = n.dot(x - p);
  const bool touches = gap < 0;
  const double push = touches ? -k * gap - d * n.dot(v) : 0;
  return n * std::fmax(push, 0);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  if (x == c) return Vec3::Zero();
  const Vec3 n = (x - c).normalized();
  return planeContact(x, v, c + R * n, n, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> lengths(m.size(), 0.0);
  double load = 0;
  for (std::size_t i = m.size() - 1; i > 0; --i) {
    load += m[i] * g;
    lengths[i] = L0 - load / k;
  }
  load += m[0] * g;
  std::vector<double> z(m.size(), -load / kPlane);
  for (std::size_t i = 1; i < m.size(); ++i) z[i] = z[i - 1] + lengths[i];
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - n * n.dot(v);
  const double limit = mu * N;
  if (c * vt.norm() <= limit) return -c * vt;
  return -limit * vt.normalized();
}
