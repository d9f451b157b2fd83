#pragma once
#include <string_view>

namespace muelle {

/// What became of a student's function or file, in the classes that `check` and `grade` share: a hand-in belongs to the
/// same one in both.
enum class Outcome {
  Passed,
  Wrong,         ///< it returned, and something else than was expected (an exception counts as such)
  NeverWritten,  ///< it returned memory to which nothing was written
  Forbidden,     ///< it asked the operating system for something that no exercise needs
  Crash,         ///< a signal, an assertion, exit() instead of return, memory used up
  Cpu,           ///< its limit of processor time
  Link,          ///< it compiles, and does not fit its contract
  Compile,       ///< it does not compile
  Refused,       ///< the file itself: too large, no text, missing
  Killed,        ///< from outside, by SIGKILL: the machine's word until it has happened twice
  Wall,          ///< a wide limit of wall time: the machine's word, too
  Struck,        ///< from outside by another signal, as the process itself tells: believed once
};

/// "passed", "never written", ...: for records and tests.
std::string_view nameOf(Outcome outcome);

/// The outcome of that name; Outcome::Wrong for a name that is none.
Outcome outcomeNamed(std::string_view name);

}  // namespace muelle
