// loses: PlaneContact, PlaneNeverPulls, ContactLaws, Bounce; misconception: plane_absolute_speed
// thought: the damper helps to push
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double delta = (p - x).dot(n);
  if (delta <= 0) return Vec3::Zero();
  return (k * delta + d * std::abs(v.dot(n))) * n;
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
