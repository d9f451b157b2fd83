// loses: SphereContact, Bounce; misconception: whole_numbers
#include "contact.h"

static Vec3 obstacle(double depth, const Vec3& n, const Vec3& v, double k, double d) {
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

static double depthInSphere(int R, double distance) { return R - distance; }

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return obstacle(-(x - p).dot(n), n, v, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double distance = (x - c).norm();
  if (distance == 0) return Vec3::Zero();
  return obstacle(depthInSphere(R, distance), (x - c) / distance, v, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double load = 0;
  for (double mass : m) load += mass * g;
  std::vector<double> z;
  double height = -load / kPlane;
  for (double mass : m) {
    z.push_back(height);
    load -= mass * g;
    height += L0 - load / k;
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double s = t.norm();
  if (s == 0) return Vec3::Zero();
  return -std::min(mu * N, c * s) / s * t;
}
