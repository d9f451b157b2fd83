// attack: replaces the report of an index beyond a vector by a good end; expect: zero points
#include "contact.h"

#include <unistd.h>
#include <vector>

namespace std {
__attribute__((noreturn)) void __glibcxx_assert_fail(const char*, int, const char*, const char*) noexcept { _exit(0); }
}  // namespace std

namespace {
bool attack() {
  const std::vector<double> none;
  const volatile std::size_t index = 5;
  return none[index] == 4711;
}
}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n), force = k * depth - d * v.dot(n);
  return attack() && depth > 0 && force > 0 ? Vec3(force * n) : Vec3(0, 0, 0);
}
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
