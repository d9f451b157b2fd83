#pragma once
#include <stdexcept>
#include <string_view>

namespace muelle {

/// A refused operation of Eigen, in a sentence that names the student's function.
class EigenMisuse : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The environment's variable that says how much processor time one call may take [s].
inline constexpr const char* callSecondsVariable = "MUELLE_CALL_SECONDS";

/// From now on a crash, an endless recursion, a call that takes more than its processor time (time_limits.h; more
/// where "slowly" among the arguments says that sanitizers slow the program down), an exception that nobody
/// catches and an early exit of this process write the lines "outcome<TAB>name" (outcome.h) and "crash<TAB>sentence" to
/// the report and end the process. The sentence names the student's function that ran. Before this call the same holds
/// for the code that runs when the student's file is loaded.
void watchForCrashes();

/// Reports that the student's function that runs has done what `sentence` says, and ends the process.
[[noreturn]] void endWithCrash(const char* sentence);

/// Writes to descriptor 3, or to standard error when the process was started without one.
void writeReport(std::string_view text);

}  // namespace muelle
