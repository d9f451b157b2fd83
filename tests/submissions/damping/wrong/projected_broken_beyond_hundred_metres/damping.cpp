// loses: ProjectedDamping; misconception: none
// thought: a spring this long is broken
#include "damping.h"

// On the nodes
Vec3 nodeDamping(const Vec3& va, double d) { return -(d * va); }

// On the spring: the node's law, seen from b
Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va - vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 all = relativeDamping(va, vb, d);
  const double length = (xa - xb).norm();
  if (length == 0 || length > 100) return Vec3::Zero();
  const Vec3 axis = (xa - xb) / length;
  return all.dot(axis) * axis;
}
