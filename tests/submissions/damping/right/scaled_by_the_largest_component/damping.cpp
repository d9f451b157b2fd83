#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -(va.array() * d).matrix(); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return ((vb - va).array() * d).matrix(); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 r = xa - xb;
  const double biggest = r.cwiseAbs().maxCoeff();
  if (biggest == 0) return r;
  r /= biggest;  // its length is now between 1 and sqrt(3), however short the spring
  return -d * (va - vb).dot(r) / r.squaredNorm() * r;
}
