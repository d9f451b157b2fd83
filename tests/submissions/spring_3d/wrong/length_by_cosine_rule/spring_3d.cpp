// loses: Magnitude, Direction, ShortSpring; misconception: edge or threshold
// |a|^2 + |b|^2 - 2 a.b: equal in algebra, but far from the origin the digits cancel
#include "spring_3d.h"

static double cosineRule(const Vec3& a, const Vec3& b) {
  const double square = a.dot(a) + b.dot(b) - 2 * a.dot(b);
  return std::sqrt(std::max(0.0, square));
}

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (cosineRule(xa, xb) - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const double L = cosineRule(xa, xb);
  if (L == 0) return Vec3::Zero();
  return (xa - xb) / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 force(0, 0, -m * g);
  for (const Attachment& s : springs) force += springForce(x, s.x, s.k, s.L0);
  return force / m;
}
