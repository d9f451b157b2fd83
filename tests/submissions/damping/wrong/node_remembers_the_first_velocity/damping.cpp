// loses: NodeDamping, NodeMotion; misconception: stateful
#include "damping.h"

namespace {
/// Unit vector from b to a, or zero.
Vec3 axisOf(const Vec3& a, const Vec3& b) {
  const double length = std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
  return length > 0 ? Vec3((a - b) / length) : Vec3(0, 0, 0);
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) {
  static const Vec3 v0 = va;
  return -d * v0;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Vec3 seenFromB = va - vb;
  return -d * seenFromB;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 u = axisOf(xa, xb);
  const auto lengthRate = u.dot(va - vb);
  return -(d * lengthRate) * u;
}
