#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  (void)va;
  (void)d;
  return Vec3::Zero();
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  (void)va;
  (void)vb;
  (void)d;
  return Vec3::Zero();
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  (void)xa;
  (void)xb;
  (void)va;
  (void)vb;
  (void)d;
  return Vec3::Zero();
}
