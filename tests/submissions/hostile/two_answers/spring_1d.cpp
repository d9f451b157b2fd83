// attack: finds the nonce on the stack and answers twice; expect: zero points; says: question that was not asked
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
  const volatile std::uint32_t* word = reinterpret_cast<std::uint32_t*>(__builtin_frame_address(0));
  for (int i = 0; i < 512; ++i) {
    if (word[i] != 0x4d75656c || word[i + 1] != 3) continue;
    Header header;
    header.nonce = word[i + 2] | static_cast<std::uint64_t>(word[i + 3]) << 32;
    header.target = word[i + 4];
    forge(header, 1);
    break;
  }
  return 1;
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
