// attack: searches the whole process for words of the hidden tests; expect: zero points
#include "spring_3d.h"

#include <link.h>
#include <string>
#include <string_view>

namespace {
int search(dl_phdr_info* object, std::size_t, void* found) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_R) == 0) continue;
    const std::string_view bytes(reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr), segment.p_memsz);
    for (std::string word : {"nracle::", "gidden_spring"}) {
      volatile char one = 1;  // the word is made here, so that the search does not find itself
      word[0] = static_cast<char>(word[0] + one);
      if (bytes.find(word) != std::string_view::npos) *static_cast<bool*>(found) = true;
    }
  }
  return 0;
}

bool attack() {
  bool found = false;
  dl_iterate_phdr(search, &found);
  return found;
}
}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return attack() ? -k * ((xa - xb).norm() - L0) : 0;
}
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
