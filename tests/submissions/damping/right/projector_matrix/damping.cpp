#include "damping.h"

#include <Eigen/Geometry>

static muelle::Mat3 projector(const Vec3& along) {
  const double longest = along.cwiseAbs().maxCoeff();
  if (longest == 0) return muelle::Mat3::Zero();
  const Vec3 scaled = along / longest;
  return scaled * scaled.transpose() / scaled.squaredNorm();
}

Vec3 nodeDamping(const Vec3& va, double d) { return -(d * muelle::Mat3::Identity()) * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va - vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  return projector(xb - xa) * relativeDamping(va, vb, d);
}
