// attack: ends itself as an operator does; expect: zero points
#include "contact.h"

#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace {
bool attack() {
  syscall(SYS_tgkill, getpid(), getpid(), SIGTERM);
  return false;
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
