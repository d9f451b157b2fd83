// loses: ColumnAtRest; misconception: never_written
#include "contact.h"

namespace {

/// The push of an obstacle along its outward normal n; a contact never pulls.
Vec3 push(double depth, const Vec3& v, const Vec3& n, double k, double d) {
  if (depth <= 0.0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  return push(depth, v, n, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double distance = (x - c).norm();
  if (distance == 0.0) return Vec3::Zero();
  const Vec3 n = (x - c) / distance;
  return push(R - distance, v, n, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double load = 0.0;  // weight that the node at hand and those above it put on what is below it [N]
  for (const double mass : m) load += mass * g;

  double* z = new double[m.size()];
  double height = -load / kPlane;
  for (std::size_t i = 0; i < m.size(); ++i) {
    z[i] += height;
    load -= m[i] * g;
    height += L0 - load / k;
  }
  const std::vector<double> heights(z, z + m.size());
  delete[] z;
  return heights;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 tangential = v - v.dot(n) * n;
  const double speed = tangential.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * tangential / speed;
}
