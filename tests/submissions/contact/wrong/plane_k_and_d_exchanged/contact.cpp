// loses: PlaneContact, ContactLaws, Bounce; misconception: swapped_arguments
#include "contact.h"

static Vec3 push(double depth, double vn, const Vec3& n, double d, double k) {
  if (depth <= 0) return Vec3::Zero();
  return std::max(0.0, k * depth - d * vn) * n;
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return push(-(x - p).dot(n), v.dot(n), n, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 n = x - c;
  const double distance = std::hypot(n.x(), n.y(), n.z());
  const double depth = R - distance;
  if (!(depth > 0) || !(distance > 0)) return Vec3(0, 0, 0);
  n /= distance;
  const double push = k * depth - d * n.dot(v);
  return push > 0 ? Vec3(push * n) : Vec3(0, 0, 0);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> weight(m.size());
  double sum = 0;
  for (int i = (int)m.size() - 1; i >= 0; i--) {
    sum += m[i] * g;
    weight[i] = sum;
  }
  std::vector<double> z = {-weight[0] / kPlane};
  for (size_t i = 1; i < m.size(); i++) z.push_back(z[i - 1] + (L0 - weight[i] / k));
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
