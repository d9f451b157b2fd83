#pragma once
#include "base/process/descriptor.h"

#include <sys/types.h>
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace muelle {

/// Limits that a child gets before it starts its program; 0 leaves one as it is.
struct ResourceLimits {
  std::size_t addressSpace = 0;  ///< [bytes]
  std::size_t fileSize = 0;      ///< [bytes]
  std::size_t stack = 0;         ///< [bytes]
  unsigned cpuSeconds = 0;       ///< of one process, ended by SIGXCPU; SIGKILL follows 2 s later
  unsigned processes = 0;        ///< of the child's user id, threads included
};

/// A program to start.
struct ChildSpec {
  std::vector<std::string> command;      ///< program (looked up in PATH when it has no slash) and arguments; no shell
  std::map<int, int> descriptors;        ///< number in the child -> ours; every other descriptor is closed
  std::vector<std::string> environment;  ///< "NAME=value"
  bool inheritsEnvironment = false;      ///< ours, with `environment` over it
  ResourceLimits limits;
  std::string workingDirectory;  ///< empty: ours
  /// Shares our terminal, process group and standard streams; limits and environment as above.
  bool isForeground = false;
};

/// How a child ended.
struct ExitStatus {
  bool signalled = false;
  int code = 0;             ///< exit status, or the signal
  double cpuSeconds = 0.0;  ///< processor time of the child and of the children that it has waited for

  bool success() const { return !signalled && code == 0; }
};

/// A running child in a session and process group of its own (unless it runs in the foreground), killed with its owner.
/// On Linux it is killed too when the thread that has started it ends.
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
  bool ownsGroup_ = true;
  std::shared_ptr<void> companion_;
};

/// Lets this process survive a write to a pipe whose reader has died: write() fails with EPIPE instead.
void ignoreClosedPipes();

/// How long a command may run, and how much is kept of what it writes; the rest is read and dropped.
struct Capture {
  std::chrono::milliseconds limit{10'000};  ///< of wall time; then its whole group is killed
  std::size_t outBytes = 65536;
  std::size_t errBytes = 65536;
  std::size_t reportBytes = 0;  ///< of descriptor 3, which is given to the command unless this is 0
  bool together = false;        ///< standard error goes into `out`, in the order of writing
};

/// What a finished command left.
struct CommandResult {
  std::string out;     ///< standard output, cut at the limit
  std::string err;     ///< standard error, cut at the limit
  std::string report;  ///< what it wrote to descriptor 3, cut at the limit
  bool outCut = false;
  bool errCut = false;
  bool timedOut = false;
  ExitStatus status;
};

/// Runs a command without input to its end, draining its outputs whatever their length. A process that it leaves behind
/// is killed, and does not hold us up though it has our pipes.
CommandResult runCommand(ChildSpec spec, const Capture& capture);

/// Runs a program with this terminal as its own, and waits. Returns its exit code, or 128 + signal.
/// Throws std::runtime_error when it cannot be started.
int runInForeground(const std::vector<std::string>& command);

}  // namespace muelle
