// loses: ProjectedDamping, PairLaws, ProjectedMotion; misconception: projected_component_missing or missing_component
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0) return Vec3::Zero();
  const double ux = r.x() / L, uy = r.y() / L, uz = r.z() / L;
  const double rate = (va.x() - vb.x()) * ux + (va.y() - vb.y()) * uy;
  return -d * rate * Vec3(ux, uy, uz);
}
