// loses: NodeDamping, NodeMotion; misconception: always_negative
// thought: minus the size, in each component
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va.cwiseAbs();
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) {
    return Vec3::Zero();
  }
  Vec3 u = r / L;
  double rate = (va - vb).dot(u);
  return -d * rate * u;
}
