// attack: opens a folder to everybody from a constructor; expect: zero points
#include "contact.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace {
const bool won = [] {
  const bool mode = chmod("/tmp", 01777) == 0;
  return fchmodat(AT_FDCWD, "/tmp", 01777, 0) == 0 || mode;
}();
}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n), force = k * depth - d * v.dot(n);
  return won && depth > 0 && force > 0 ? Vec3(force * n) : Vec3(0, 0, 0);
}
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
