// loses: PlaneNeverPulls, SphereContact, Bounce; misconception: plane_pulls or sphere_inward_normal or sphere_inward
// two mistakes: no max(0, ...) for the plane, and c - x for the sphere's normal
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double depth = -(x - p).dot(n);
  if (depth <= 0) return Vec3::Zero();
  return (k * depth - d * v.dot(n)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dist = (x - c).norm();
  if (dist == 0) return Vec3::Zero();
  Vec3 n = (c - x) / dist;
  double depth = R - dist;
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double M = 0;
  for (double mi : m) M += mi;
  std::vector<double> z;
  z.push_back(-M * g / kPlane);
  for (size_t i = 1; i < m.size(); i++) {
    M -= m[i - 1];
    z.push_back(z[i - 1] + L0 - M * g / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 t = v - v.dot(n) * n;
  double s = t.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) / s * t;
}
