#pragma once
#include "grader/process/descriptor.h"

#include <sys/types.h>
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// Limits that a child gets before it starts its program; 0 leaves one as it is.
struct ResourceLimits {
  std::size_t addressSpace = 0;  ///< [bytes]
  std::size_t fileSize = 0;      ///< [bytes]
  unsigned cpuSeconds = 0;
  unsigned processes = 0;  ///< of the child's user id, threads included
};

/// A program to start.
struct ChildSpec {
  std::vector<std::string> command;      ///< absolute path and arguments; no shell
  std::map<int, int> descriptors;        ///< number in the child -> ours; every other descriptor is closed
  std::vector<std::string> environment;  ///< "NAME=value"; nothing is inherited
  ResourceLimits limits;
  std::string workingDirectory;  ///< empty: ours
};

/// How a child ended.
struct ExitStatus {
  bool signalled = false;
  int code = 0;  ///< exit status, or the signal
};

/// A running child in a session and process group of its own, killed with its owner.
class Child {
 public:
  Child() = default;
  /// Throws std::runtime_error when the program cannot be started.
  explicit Child(const ChildSpec& spec);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child() { kill(); }

  /// Keeps something (a folder of the sandbox) as long as the child lives.
  void keep(std::shared_ptr<void> companion) { companion_ = std::move(companion); }

  pid_t pid() const { return pid_; }
  bool running() const { return pid_ > 0; }
  /// Waits until it ends, at most until the deadline; nullopt when it still runs.
  std::optional<ExitStatus> wait(std::chrono::steady_clock::time_point deadline);
  /// Kills the whole group and reaps the child; harmless when it has ended.
  void kill();

 private:
  pid_t pid_ = -1;
  std::shared_ptr<void> companion_;
};

/// Lets this process survive a write to a pipe whose reader has died: write() fails with EPIPE instead.
void ignoreClosedPipes();

/// What a finished command left.
struct CommandResult {
  std::string out;  ///< standard output, cut at the limit
  std::string err;  ///< standard error, cut at the limit
  bool outCut = false;
  bool timedOut = false;
  ExitStatus status;
};

/// Runs a command to its end, draining both outputs whatever their length.
CommandResult runCommand(ChildSpec spec, std::chrono::milliseconds limit, std::size_t outBytes, std::size_t errBytes);

}  // namespace muelle::grader
