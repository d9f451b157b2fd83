#pragma once
/// \file
/// What a fault of the processor means, told in the same words by the student's check and by the grader. Signal
/// handlers use it: nothing here allocates.

#include <cstdint>

namespace muelle {

inline constexpr const char* stackOverflowSentence =
    "ran out of stack: does it call itself without end, or hold local variables larger than the stack?";
inline constexpr const char* trapSentence = "made floating-point operations stop the program: leave that as it is";

/// Whether a fault at the address is of a stack that begins at `top` and has outgrown its `limit` [bytes]: just below
/// its end, or further below, where a large local array has jumped over the end.
inline bool isStackOverflow(const void* address, std::uintptr_t top, std::uintptr_t limit) {
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  constexpr std::uintptr_t slack = 1U << 20U;
  constexpr std::uintptr_t jump = 64U << 20U;
  const std::uintptr_t end = top - limit;
  return at < end + slack && at + jump > end;
}

}  // namespace muelle
