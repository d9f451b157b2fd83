// attack: answers from a constructor, before it is asked; expect: zero points; says: question that was not asked
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

const bool forged = [] {
  Header ready;
  ready.kind = 1;
  ready.bytes = 0;
  if (write(4, &ready, sizeof ready) < 0) _exit(1);
  for (int i = 0; i < 20; ++i) forge(Header{}, 1);
  return true;
}();
}  // namespace

double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
