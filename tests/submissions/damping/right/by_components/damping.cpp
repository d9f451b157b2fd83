#include "damping.h"

// Component by component, without Eigen's vector functions.

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 force;
  for (int i = 0; i < 3; ++i) force(i) = -d * va(i);
  return force;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 force;
  for (int i = 0; i < 3; ++i) force(i) = d * (vb(i) - va(i));
  return force;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  double dx = xa(0) - xb(0);
  double dy = xa(1) - xb(1);
  double dz = xa(2) - xb(2);
  double L = std::sqrt(dx * dx + dy * dy + dz * dz);
  Vec3 force(0.0, 0.0, 0.0);
  if (L > 0.0) {
    dx /= L;
    dy /= L;
    dz /= L;
    double speed = (va(0) - vb(0)) * dx + (va(1) - vb(1)) * dy + (va(2) - vb(2)) * dz;
    force(0) = -d * speed * dx;
    force(1) = -d * speed * dy;
    force(2) = -d * speed * dz;
  }
  return force;
}
