// attack: overwrites the data of the program that has loaded it; expect: zero points
#include "contact.h"

#include <link.h>

namespace {
int overwrite(dl_phdr_info* object, std::size_t, void*) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) == 0) continue;
    auto* bytes = reinterpret_cast<volatile unsigned char*>(object->dlpi_addr + segment.p_vaddr);
    for (std::size_t at = segment.p_memsz; at-- > 0;) bytes[at] = 0;
  }
  return 1;  // the program itself comes first
}

bool attack() {
  dl_iterate_phdr(overwrite, nullptr);
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
