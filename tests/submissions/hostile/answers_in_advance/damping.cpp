// attack: answers the next calls too, with the nonce of this one; expect: zero points
#include "damping.h"

#include <unistd.h>
#include <cstdint>
#include <cstring>

namespace {
struct Header {
  std::uint32_t magic = 0x4d75656c;
  std::uint32_t kind = 4;
  std::uint64_t nonce = 0;
  std::uint32_t target = 0;
  std::uint32_t bytes = 8;
};

bool attack(const Vec3& force) {
  const volatile std::uint32_t* word = reinterpret_cast<std::uint32_t*>(__builtin_frame_address(0));
  for (int i = 0; i < 512; ++i) {
    if (word[i] != 0x4d75656c || word[i + 1] != 3) continue;
    Header header;
    header.nonce = word[i + 2] | static_cast<std::uint64_t>(word[i + 3]) << 32;
    header.target = word[i + 4];
    header.bytes = sizeof(double[3]);
    char message[sizeof header + sizeof(double[3])];
    std::memcpy(message, &header, sizeof header);
    std::memcpy(message + sizeof header, force.data(), sizeof(double[3]));
    for (int copies = 0; copies < 8; ++copies) {
      if (write(4, message, sizeof message) < 0) _exit(1);
    }
    break;
  }
  return false;
}
}  // namespace

Vec3 nodeDamping(const Vec3& va, double d) { return attack(va) ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
