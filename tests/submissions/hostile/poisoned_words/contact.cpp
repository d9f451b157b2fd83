// attack: forbids the words that the grader's own code needs; expect: zero points
#include "contact.h"

#pragma GCC poison muelleServe encode decode worker
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC push_options
#pragma GCC optimize("O0", "fast-math", "omit-frame-pointer")
#pragma GCC visibility push(hidden)

Vec3 planeContact(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
