// attack: makes the compiler print a type whose name has a thousand million letters; expect: zero points
#include "contact.h"

template <class A, class B>
struct Pair {};
template <int N>
struct Twice {
  using Type = Pair<typename Twice<N - 1>::Type, typename Twice<N - 1>::Type>;
};
template <>
struct Twice<0> {
  using Type = int;
};
int broken = Twice<30>::Type();

Vec3 planeContact(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
