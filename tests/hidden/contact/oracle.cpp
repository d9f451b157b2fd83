#include "contact.h"

namespace oracle {

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double height = n.dot(x) - n.dot(p);
  // On the surface the difference of products may round to either side; the difference of positions cannot.
  if (n.dot(x - p) >= 0.0) return Vec3::Zero();
  const double force = -(k * height + d * n.dot(v));
  return force > 0.0 ? Vec3(n * force) : Vec3(Vec3::Zero());
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double distance = std::hypot(r.x(), r.y(), r.z());
  if (distance == 0.0 || distance >= R) return Vec3::Zero();
  const Vec3 n(r.x() / distance, r.y() / distance, r.z() / distance);
  const double force = k * (R - distance) - d * n.dot(v);
  return force > 0.0 ? Vec3(n * force) : Vec3(Vec3::Zero());
}

// Each node on its own: the rest height of node i, less what every node j presses out of the plane and of the springs
// below both i and j.
std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const std::size_t n = m.size();
  std::vector<double> z(n);
  for (std::size_t i = 0; i < n; ++i) {
    z[i] = static_cast<double>(i) * L0;
    for (std::size_t j = 0; j < n; ++j) z[i] -= m[j] * g * (1.0 / kPlane + static_cast<double>(std::min(i, j)) / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 tangential = v - n * n.dot(v);
  const double speed = std::sqrt(tangential.dot(tangential));
  if (c * speed <= mu * N) return tangential * -c;
  return tangential * (-mu * N / speed);
}

}  // namespace oracle
