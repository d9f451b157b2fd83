#pragma once
/// \file
/// What ended a call, told in the same words by the student's check and by the grader; each follows the name of a
/// function. Signal handlers use it: what returns no std::string allocates nothing.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace muelle {

inline constexpr const char* stackOverflowSentence =
    "ran out of stack: does it call itself without end, or hold local variables larger than the stack?";
inline constexpr const char* trapSentence = "made floating-point operations stop the program: leave that as it is";
inline constexpr const char* divisionSentence = "divided an integer by zero";
inline constexpr const char* badMemorySentence = "used memory that is not its own: an index or a pointer is wrong";
inline constexpr const char* nowhereSentence = "ran into nowhere: does every way through it return a value?";
inline constexpr const char* abortSentence = "called abort(): an assertion failed or memory was damaged or used up";
inline constexpr const char* struckSentence = "was ended by a signal from outside";
inline constexpr const char* waitsSentence = "waits without end for something that never comes";

inline constexpr const char* luckSentence =
    "depends on memory to which nothing was written: give every variable a value before it is read";

/// Goes in the place of a function's name before any test has called one.
inline constexpr const char* loadingCode = "the code that runs when your file is loaded";

/// What it means that a signal ended a student's code; nullptr for a signal that is no word about the code.
const char* signalSentence(int signal);

/// "did not return within 2 s of processor time"
std::string limitSentence(std::chrono::milliseconds limit);

/// "ended the program with exit(0) instead of returning". \param code of which a process keeps eight bits
std::string exitSentence(int code);

/// "threw an exception that nobody caught: no such node", as out of a noexcept function. \param text as
/// thrownSentence's
std::string uncaughtSentence(std::string_view text);

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
