// loses: PlaneContact, ContactLaws, Bounce; misconception: plane_damps_all
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  const Vec3 F = k * depth * n - d * v;
  if (F.dot(n) < 0) return Vec3::Zero();
  return F;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = (x - c).norm();
  if (r == 0) return Vec3::Zero();
  const double depth = R - r;
  if (depth <= 0) return Vec3::Zero();
  const Vec3 n = (x - c) / r;
  const double size = k * depth - d * v.dot(n);
  if (size < 0) return Vec3::Zero();
  return size * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double weight = 0;
  for (double mass : m) weight += mass * g;
  std::vector<double> z;
  double height = -weight / kPlane;
  for (std::size_t i = 0; i < m.size(); ++i) {
    z.push_back(height);
    weight -= m[i] * g;
    height += L0 - weight / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double s = vt.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) * vt / s;
}
