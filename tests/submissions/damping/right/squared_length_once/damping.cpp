#include "damping.h"

Vec3 nodeDamping(const Vec3& velocity, double d) { return -1.0 * d * velocity; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Vec3 difference = va - vb;
  return -1.0 * d * difference;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  // no root at all: u u^T = r r^T / (r^T r)
  const Vec3 r = xa - xb, v = va - vb;
  const double rr = r.dot(r);
  return rr == 0 ? Vec3(0, 0, 0) : Vec3(-d * (v.dot(r) / rr) * r);
}
