// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: not_projected
#include "damping.h"

// On the nodes
Vec3 nodeDamping(const Vec3& va, double d) { return -(d * va); }

// On the spring: the node's law, seen from b
Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va - vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  (void)xa, (void)xb;
  return relativeDamping(va, vb, d);
}
