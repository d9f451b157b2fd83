// attack: asks for the kernel's strict mode from a constructor; expect: zero points
#include "contact.h"

#include <linux/seccomp.h>
#include <sys/prctl.h>

namespace {
const int strict = prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT, 0, 0, 0);
}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n), force = k * depth - d * v.dot(n);
  return strict == 0 && depth > 0 && force > 0 ? Vec3(force * n) : Vec3(0, 0, 0);
}
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
