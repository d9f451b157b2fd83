// attack: says from the earliest constructor that the file cannot be loaded; expect: zero points
#include "contact.h"

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

__attribute__((constructor(101))) void early() {
  Header header;
  header.kind = 2;
  for (std::uint32_t kind = 0; kind < 16; ++kind) {
    header.kind = kind;
    char message[sizeof header + 8] = {};
    std::memcpy(message, &header, sizeof header);
    if (write(4, message, sizeof message) < 0) _exit(1);
  }
}
}  // namespace

Vec3 planeContact(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
