// loses: NodeDamping, NodeMotion; misconception: node_vertical
// thought: the fall is along z
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 F = Vec3::Zero();
  F[2] = -d * va[2];
  return F;
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
