#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// A program to run, and how much of it to bear.
struct ChildRequest {
  std::vector<std::string> command;  ///< program (looked up in PATH) and arguments
  std::filesystem::path folder;      ///< working folder; empty: the caller's
  double seconds = 10.0;             ///< killed with its whole process group when this is over
  std::size_t outputLimit = 65536;   ///< bytes kept of each stream; the rest is read and dropped
};

/// What became of it.
struct ChildResult {
  int exitCode = -1;  ///< -1 when a signal ended it
  int signal = 0;     ///< 0 when it exited
  bool timedOut = false;
  std::string output;  ///< standard output and standard error, as they came
  std::string report;  ///< what it wrote to descriptor 3
};

/// Runs a program without input, in the C locale and a process group of its own, and waits for its end; whatever it
/// leaves running is killed. Throws std::runtime_error when it cannot be started.
ChildResult runChild(const ChildRequest& request);

}  // namespace muelle
