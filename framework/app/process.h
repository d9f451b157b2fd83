#pragma once
#include <string>
#include <vector>

namespace muelle::app {

/// Runs a program found in PATH with this terminal as its own, and waits.
/// Returns its exit code, or 128 + signal. Throws std::runtime_error when it cannot be started.
int runInForeground(const std::vector<std::string>& command);

}  // namespace muelle::app
