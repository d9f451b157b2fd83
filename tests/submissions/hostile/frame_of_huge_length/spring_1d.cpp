// attack: answers on the pipe with a frame of 4 GB; expect: zero points; says: message of 4294967295 bytes
#include "spring_1d.h"

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

void forge(const Header& header, double value) {
  char message[sizeof header + sizeof value];
  std::memcpy(message, &header, sizeof header);
  std::memcpy(message + sizeof header, &value, sizeof value);
  if (write(4, message, sizeof message) < 0) _exit(1);
}

double attack() {
  Header header;
  header.bytes = 0xffffffff;
  forge(header, 1);
  return 0;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
