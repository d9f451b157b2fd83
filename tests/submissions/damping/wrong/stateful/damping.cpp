// loses: all; misconception: stateful
#include "damping.h"

#include <utility>

Vec3 nodeDamping(const Vec3& va, double d) {
  static Vec3 previous = Vec3::Zero();
  return std::exchange(previous, -d * va);
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  static Vec3 previous = Vec3::Zero();
  return std::exchange(previous, -d * (va - vb));
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  static Vec3 previous = Vec3::Zero();
  const double L = (xa - xb).norm();
  const Vec3 u = L > 0.0 ? Vec3((xa - xb) / L) : Vec3(Vec3::Zero());
  return std::exchange(previous, -d * (va - vb).dot(u) * u);
}
