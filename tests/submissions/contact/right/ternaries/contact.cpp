#include "contact.h"

static double distanceOf(const Vec3& a, const Vec3& b) {
  const Vec3 r = a - b;
  return std::hypot(r[0], r[1], r[2]);
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  const double f = depth > 0.0 ? k * depth - d * v.dot(n) : 0.0;
  return f > 0.0 ? Vec3(f * n) : Vec3(Vec3::Zero());
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double r = distanceOf(x, c);
  const Vec3 n = r > 0.0 ? Vec3((x - c) / r) : Vec3(0.0, 0.0, 0.0);
  const double f = r < R ? k * (R - r) - d * v.dot(n) : 0.0;
  return f > 0.0 ? Vec3(f * n) : Vec3(Vec3::Zero());
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> weight = m;
  for (double& w : weight) w *= g;
  for (int i = static_cast<int>(weight.size()) - 2; i >= 0; --i) weight[i] += weight[i + 1];
  std::vector<double> z(weight.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = i == 0 ? -weight[i] / kPlane : z[i - 1] + (L0 - weight[i] / k);
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - v.dot(n) * n;
  const double speed = t.stableNorm();
  return speed == 0.0 ? Vec3(Vec3::Zero()) : Vec3(t / -speed * (mu * N < c * speed ? mu * N : c * speed));
}
