#pragma once
#include <functional>
#include <stdexcept>

namespace muelle {

/// What has failed on this machine, whatever was typed: a full disk, a file that it cannot read.
class MachineFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a body; an error of the system becomes a MachineFault, unless it tells that a name was wrong.
int blamingTheMachine(const std::function<int()>& body);

/// Runs a program's body: an exception becomes one line "muelle: ..." on the standard error stream and exit code 2, a
/// MachineFault exit code 1. So does standard output that cannot be written, at the end or before: a full disk, a
/// closed stream, a reader that is gone.
int withErrorsOnOneLine(const std::function<int()>& body);

}  // namespace muelle
