// loses: PlaneContact, ContactLaws, Bounce; misconception: plane_positive_part
// thought: never pulls means no negative number
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const Vec3 f = (k * depth - d * v.dot(n)) * n;
  return f.cwiseMax(0.0);
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
