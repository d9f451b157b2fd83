// loses: PlaneContact, ContactLaws, Bounce; misconception: plane_damps_all
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const Vec3 f = k * depth * n - d * v;
  if (f.dot(n) < 0.0) return Vec3::Zero();
  return f;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dist = std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]);
  if (dist == 0) return Vec3::Zero();
  Vec3 n = (x - c) / dist;
  double delta = R - dist;
  if (delta <= 0) return Vec3::Zero();
  double f = k * delta - d * v.dot(n);
  if (f < 0) f = 0;
  return f * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const int n = m.size();
  std::vector<double> z(n);
  for (int i = 0; i < n; i++) {
    double load = 0;
    for (int j = i; j < n; j++) load += m[j] * g;
    z[i] = i == 0 ? -load / kPlane : z[i - 1] + L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
