#include "damping.h"

namespace {

using V = std::array<long double, 3>;

V minus(const Vec3& p, const Vec3& q) {
  return {static_cast<long double>(p[0]) - q[0], static_cast<long double>(p[1]) - q[1],
          static_cast<long double>(p[2]) - q[2]};
}

long double dot(const V& a, const V& b, int last = 2) { return last < 0 ? 0 : a[last] * b[last] + dot(a, b, last - 1); }

Vec3 times(long double factor, const V& a) {
  return Vec3(static_cast<double>(factor * a[0]), static_cast<double>(factor * a[1]),
              static_cast<double>(factor * a[2]));
}

}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return times(-d, minus(va, Vec3::Zero())); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return times(d, minus(vb, va)); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const V r = minus(xa, xb);
  const long double square = dot(r, r);
  if (square == 0) return Vec3::Zero();
  // The two divisions by L at once.
  return times(-d * dot(minus(va, vb), r) / square, r);
}
