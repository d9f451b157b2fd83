// loses: all; misconception: stateful
#include "spring_3d.h"

// Right values, each one call late.

namespace {

template <class Value>
Value exchange(Value& previous, const Value& now) {
  const Value answer = previous;
  previous = now;
  return answer;
}

Vec3 directionOf(const Vec3& xa, const Vec3& xb) { return (xa - xb).normalized(); }

Vec3 forceOf(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).norm() - L0) * directionOf(xa, xb);
}

}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  static double previous = 1;
  return exchange(previous, -k * ((xa - xb).norm() - L0));
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  static Vec3 previous(1, 0, 0);
  return exchange(previous, directionOf(xa, xb));
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  static Vec3 previous(1, 0, 0);
  return exchange(previous, forceOf(xa, xb, k, L0));
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  static Vec3 previous(1, 0, 0);
  Vec3 now(0, 0, -g);
  for (const Attachment& spring : springs) now += forceOf(x, spring.x, spring.k, spring.L0) / m;
  return exchange(previous, now);
}
