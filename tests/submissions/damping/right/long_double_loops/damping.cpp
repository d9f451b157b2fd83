#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 f;
  for (int i = 0; i < 3; i++) f(i) = -d * va(i);
  return f;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 f;
  for (int i = 0; i < 3; i++) f(i) = -d * (va(i) - vb(i));
  return f;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  long double squared = 0, product = 0;
  for (int i = 0; i < 3; i++) {
    const long double r = static_cast<long double>(xa(i)) - xb(i);
    squared += r * r;
    product += r * (static_cast<long double>(va(i)) - vb(i));
  }
  Vec3 f = Vec3::Zero();
  if (squared > 0)
    for (int i = 0; i < 3; i++)
      f(i) = static_cast<double>(-d * product / squared * (static_cast<long double>(xa(i)) - xb(i)));
  return f;
}
