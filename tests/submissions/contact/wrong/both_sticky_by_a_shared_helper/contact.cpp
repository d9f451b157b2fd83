// loses: PlaneNeverPulls, SphereEdges, Bounce; misconception: plane_pulls or sphere_pulls
#include "contact.h"

namespace {

Vec3 springDamper(double depth, const Vec3& n, const Vec3& v, double k, double d) {
  if (depth > 0) return (k * depth - d * n.dot(v)) * n;
  return Vec3::Zero();
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return springDamper((p - x).dot(n), n, v, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = r.norm();
  if (dist == 0.0) return Vec3::Zero();
  return springDamper(R - dist, r / dist, v, k, d);
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
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
