#pragma once
#include "base/process/child.h"
#include "grader/sandbox/sandbox.h"
#include "grader/wire/frame.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace muelle::grader {

/// What to say of a cause of death that the worker has sent: "stack overflow", or the name of a forbidden system call.
std::string deathText(const std::string& cause);

/// The process that holds a student's code, seen from the test process: frames in, frames out, deadlines, output
/// drained. Whatever arrives is checked: sizes before allocation, the nonce of the call, the kind that may come now.
class WorkerProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts the host program on a shared object, confined. Throws GraderFault when it cannot be confined,
  /// SubmissionFault when loading the code ends badly.
  WorkerProcess(const Sandbox& sandbox, const std::filesystem::path& host, const std::filesystem::path& submission);

  /// Sends one frame. \param function for messages   Throws SubmissionFault when the worker is gone or stuck.
  void send(wire::FrameKind kind, std::uint64_t nonce, std::uint32_t target, const std::vector<std::byte>& payload,
            Clock::time_point deadline, const std::string& function);

  /// The next frame. Throws SubmissionFault on a time-out, an end of the process or a malformed header.
  wire::Frame receive(std::uint64_t nonce, Clock::time_point deadline, const std::string& function);

  /// What the student's code has printed so far, cut.
  const std::string& output() const { return output_; }

  /// Process id of the outermost confined process (the sandbox's own).
  pid_t pid() const { return child_.pid(); }

 private:
  void readFully(void* data, std::size_t count, Clock::time_point deadline, const std::string& function);
  void waitFor(int descriptor, short event, Clock::time_point deadline, const std::string& function);
  void drainOutput();
  void load();
  [[noreturn]] void reportEnd(const std::string& function);

  Pipe request_;
  Pipe reply_;
  Pipe out_;
  Child child_;
  std::string output_;
  bool outputCut_ = false;
};

}  // namespace muelle::grader
