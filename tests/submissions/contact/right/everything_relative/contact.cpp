#include "contact.h"

namespace {

double positivePart(double value) { return value > 0 ? value : 0.0; }

Vec3 unit(const Vec3& a) {
  const double length = std::hypot(a.x(), a.y(), a.z());
  return length == 0 ? a : Vec3(a / length);
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const Vec3 relative = x - p;
  if (relative.dot(n) >= 0) return Vec3::Zero();
  return positivePart(-(k * relative + d * v).dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 relative = x - c;
  const Vec3 n = unit(relative);  // zero at the centre, and so is the force then
  const double dist = std::hypot(relative.x(), relative.y(), relative.z());
  if (dist >= R) return 0.0 * n;
  return positivePart(k * (R - dist) - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  double load = 0;
  // downwards: what each spring is shortened by
  for (std::size_t i = m.size() - 1; i > 0; i--) {
    load += m[i] * g;
    z[i] = L0 - load / k;
  }
  load += m.front() * g;
  z.front() = -load / kPlane;
  // upwards: heights
  for (std::size_t i = 1; i < z.size(); i++) z[i] = z[i - 1] + z[i];
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const Vec3 e = unit(vt);
  return -std::min(mu * N, c * vt.dot(e)) * e;
}
