#include "damping.h"

struct Pair {
  Vec3 r, v;
  double length() const { return r.norm(); }
  double rate() const { return v.dot(r) / length(); }
};

Vec3 nodeDamping(const Vec3& va, double d) {
  if (d == 0) return Vec3::Zero();
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Pair pair{Vec3::Zero(), va - vb};
  return -d * pair.v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Pair pair{xa - xb, va - vb};
  if (pair.length() == 0) return Vec3::Zero();
  const double size = -d * pair.rate();
  return size * pair.r / pair.length();
}
