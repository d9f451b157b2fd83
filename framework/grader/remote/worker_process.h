#pragma once
#include "base/process/child.h"
#include "course/check/compile_rules.h"
#include "course/check/outcome.h"
#include "course/time_limits.h"
#include "grader/remote/fault.h"
#include "grader/remote/process_watch.h"
#include "grader/sandbox/sandbox.h"
#include "grader/wire/frame.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace muelle::grader {

/// What a cause of death that the worker has sent means: "stack overflow", the finding of a sanitizer, or the name of a
/// forbidden system call. \param who the function that was called
SubmissionFault deathFault(const std::string& who, const std::string& cause);

/// The program that loads a submission.
struct WorkerHost {
  std::filesystem::path program;
  bool sanitised = false;  ///< linked with AddressSanitizer: no limit of its address space, memory bounded by us
  bool refilled = false;   ///< fresh memory holds zeros, not the usual fill
};

/// How long a student's code may take. Limits of processor time cost points; those of wall time are wide, and passing
/// one is the machine's doing, unless the code has put itself to sleep for ever.
struct SessionLimits {
  std::chrono::milliseconds call = std::chrono::seconds(usualCallSeconds);  ///< processor time of one call
  std::chrono::milliseconds criterion = std::chrono::seconds(allCallsSeconds(usualCallSeconds));  ///< of all calls
  std::chrono::milliseconds load{2000};  ///< processor time of the code that runs when the file is loaded
  std::chrono::milliseconds callWall{30000};
  std::chrono::milliseconds loadWall{30000};
  std::chrono::milliseconds startWall{30000};  ///< for the sandbox itself
  std::size_t sanitisedMemory = 1UL << 30;     ///< [bytes] of the sanitised host

  /// For an exercise whose calls may take so long [s] of processor time. The wall is as far away as it was.
  SessionLimits forCallsOf(int seconds) const {
    SessionLimits limits = *this;
    limits.call = std::chrono::seconds(seconds);
    limits.criterion = std::chrono::seconds(allCallsSeconds(seconds));
    limits.callWall += 3 * (limits.call - std::min(limits.call, call));
    return limits;
  }

  /// With the time that the same code takes with sanitizers in it.
  SessionLimits forSanitised() const {
    SessionLimits limits = *this;
    for (auto* time : {&limits.call, &limits.criterion, &limits.load, &limits.callWall, &limits.loadWall})
      *time *= sanitizedFactor;
    return limits;
  }
};

/// What may be used up until an answer has arrived.
struct Patience {
  std::chrono::nanoseconds cpu;  ///< of the worker's processor clock: when to stop
  std::chrono::steady_clock::time_point wall;
  std::chrono::milliseconds wallSpan;  ///< the whole of the wall limit, for what counts as asleep at its end
};

/// The process that holds a student's code, seen from the test process: frames in, frames out, limits watched, output
/// drained. Whatever arrives is checked: sizes before allocation, the nonce of the call, the kind that may come now.
class WorkerProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts the host program on a shared object, confined. Throws GraderFault when it cannot be confined,
  /// SubmissionFault when loading the code ends badly.
  WorkerProcess(const Sandbox& sandbox, const WorkerHost& host, const std::filesystem::path& submission,
                const SessionLimits& limits);

  /// Sends one frame. \param function for messages   Throws SubmissionFault when the worker is gone or stuck.
  void send(wire::FrameKind kind, std::uint64_t nonce, std::uint32_t target, const std::vector<std::byte>& payload,
            const Patience& patience, const std::string& function);

  /// The next frame. Throws SubmissionFault when a limit is passed, at an end of the process or a malformed header.
  wire::Frame receive(std::uint64_t nonce, const Patience& patience, const std::string& function);

  /// How long to wait from now on. \param cpu further processor time
  Patience patience(std::chrono::nanoseconds cpu, std::chrono::milliseconds wall) const;
  /// Processor time of the host, the loaded code included.
  std::chrono::nanoseconds cpu() const { return watch_.cpu(); }

  /// Ends the process; what it has printed stays.
  void end();

  /// What the student's code has printed so far, cut.
  const std::string& output() const { return output_; }

  /// Process id of the outermost confined process (the sandbox's own), and of the host program itself.
  pid_t pid() const { return child_.pid(); }
  pid_t hostPid() const { return watch_.pid(); }

 private:
  void readFully(void* data, std::size_t count, const Patience& patience, const std::string& function);
  void waitFor(int descriptor, short event, const Patience& patience, const std::string& function);
  void look(const Patience& patience, const std::string& function);
  void drainOutput();
  void load(const SessionLimits& limits);
  void expectConfined(const Patience& patience);
  wire::Frame loaded(std::chrono::milliseconds limit, const Patience& patience);
  /// Of a process that no longer reads, and told of its death after its last answer.
  void throwLastWords(const std::string& function);
  [[noreturn]] void reportEnd(const std::string& function);

  Pipe request_;
  Pipe reply_;
  Pipe out_;
  Child child_;
  ProcessWatch watch_;
  Clock::time_point lastLook_;
  std::size_t largestMemory_ = 0;  ///< [bytes] resident; 0: the worker bounds itself
  bool hasProcessBetween_;         ///< our child is the sandbox's, not the host
  std::string output_;
  bool outputCut_ = false;
};

}  // namespace muelle::grader
