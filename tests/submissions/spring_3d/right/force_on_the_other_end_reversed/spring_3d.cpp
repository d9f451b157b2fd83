#include "spring_3d.h"

// I compute what b does to a as minus what a does to b.

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -(k * (xa - xb).norm() - k * L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 fromBToA = xa - xb;
  if (fromBToA.x() == 0 && fromBToA.y() == 0 && fromBToA.z() == 0) return fromBToA;
  return fromBToA / fromBToA.norm();
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -(springForceMagnitude(xb, xa, k, L0) * springDirection(xb, xa));
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 acceleration(0, 0, -g);
  for (const Attachment& s : springs) acceleration -= springForce(s.x, x, s.k, s.L0) / m;
  return acceleration;
}
