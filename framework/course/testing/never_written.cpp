#include "course/testing/never_written.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace muelle {

namespace {

/// GCC's pattern in a float, and what small summands leave of it.
bool isFillOfFloat(double value) {
  constexpr double pattern = std::bit_cast<float>(0xFEFEFEFEU);
  constexpr double epsilon = 1e-6;                           // ten times a float's
  return std::abs(std::abs(value / pattern) - 1) < epsilon;  // of either sign
}

}  // namespace

bool isFill(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t magnitude = ~std::uint64_t{0} >> 1U;
  constexpr std::uint64_t eigens = 0x7FF80000FEFEFEFEU;   // of harness/eigen_fill.h; a NaN of 0/0 has other bits
  constexpr std::uint64_t clangs = magnitude;             // all bits set, the sign aside, which a minus turns
  constexpr std::uint64_t bytesAA = 0xAAAAAAAAAAAAAAAAU;  // clang's, where the memory was no floating-point variable
  if ((bits & magnitude) == eigens || (bits & magnitude) == clangs || bits == bytesAA) return true;
  if (isFillOfFloat(value)) return true;
  // GCC's pattern and the heap's are bytes 0xFE: -5.3e303 as a number. No quantity of the course comes near it, and
  // multiplying or dividing by one that does not exceed 1e13 leaves it above this limit.
  constexpr double limit = 1e290;
  return std::isfinite(value) && std::abs(value) > limit;
}

bool isFillInteger(long value) {
  const auto low = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value));
  return low == 0xFEFEFEFEU || low == 0xAAAAAAAAU;
}

const char* neverWrittenSentence() {
  return "returned memory to which nothing was written: give every variable a value before it is read";
}

}  // namespace muelle
