#include "course/testing/never_written.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace muelle {

bool isFill(double value) {
  constexpr std::uint64_t eigensNaN = 0x7FF8000000000000;  // 0.0 / 0.0 has the sign bit set on the machines we know
  constexpr std::uint64_t clangsNaN = 0xFFFFFFFFFFFFFFFF;
  constexpr double beyondPhysics = 1e290;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  if (bits == eigensNaN || bits == clangsNaN) return true;
  return std::isfinite(value) && std::abs(value) > beyondPhysics;
}

}  // namespace muelle
