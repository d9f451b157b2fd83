#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  auto brake = [d](double v) { return -d * v; };
  return {brake(va.x()), brake(va.y()), brake(va.z())};
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  auto brake = [d](double a, double b) { return d * (b - a); };
  return {brake(va.x(), vb.x()), brake(va.y(), vb.y()), brake(va.z(), vb.z())};
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  auto unit = [](Vec3 v) {
    const double n = v.norm();
    if (n > 0) v /= n;
    return v;
  };
  const Vec3 u = unit(xa - xb);
  return u * (d * (vb - va).dot(u));
}
