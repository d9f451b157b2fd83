// loses: ColumnAtRest; misconception: first_for_all or first_only or constant_argument
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double delta = (p - x).dot(n);
  double vn = v.dot(n);
  Vec3 F(0, 0, 0);
  if (delta > 0) {
    F = std::max(0.0, k * delta - d * vn) * n;
  }
  return F;
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
  const double w = m[0] * g;
  const int n = m.size();
  std::vector<double> z = {-n * w / kPlane};
  for (int i = 1; i < n; i++) z.push_back(z[i - 1] + L0 - (n - i) * w / k);
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double speed = vt.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(mu * N, c * speed) * vt / speed;
}
