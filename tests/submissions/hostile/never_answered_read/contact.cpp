// attack: hands every read of the host to a listener that never answers; expect: zero points
#include "contact.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstddef>
#include <iterator>

namespace {
const long installed = [] {
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_read, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program);
}();
}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n), force = k * depth - d * v.dot(n);
  return installed == -2 && depth > 0 && force > 0 ? Vec3(force * n) : Vec3(0, 0, 0);
}
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
