#include "contact.h"

#include <Eigen/Geometry>

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  Vec3 force = Vec3::Zero();
  const double delta = -n.dot(x - p);
  if (delta > 0.0) {
    const double push = k * delta - d * n.dot(v);
    if (push > 0.0) force += push * n;
  }
  return force;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 force = Vec3::Zero();
  const Vec3 arm = x - c;
  const double distance = std::hypot(arm.x(), arm.y(), arm.z());
  if (distance > 0.0 && distance < R) {
    const Vec3 n = arm / distance;
    const double push = k * (R - distance) - d * n.dot(v);
    if (push > 0.0) force += push * n;
  }
  return force;
}

namespace {

/// Weight of the nodes from number i upwards.
double weightFrom(const std::vector<double>& m, std::size_t i, double g) {
  return i == m.size() ? 0.0 : m[i] * g + weightFrom(m, i + 1, g);
}

double height(const std::vector<double>& m, std::size_t i, double k, double L0, double kPlane, double g) {
  if (i == 0) return -weightFrom(m, 0, g) / kPlane;
  return height(m, i - 1, k, L0, kPlane, g) + L0 - weightFrom(m, i, g) / k;
}

}  // namespace

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z;
  for (std::size_t i = 0; i < m.size(); ++i) z.push_back(height(m, i, k, L0, kPlane, g));
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 tangential = n.cross(v.cross(n));  // for |n| = 1
  const double speed = std::hypot(tangential.x(), tangential.y(), tangential.z());
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N / speed, c) * tangential;
}
