#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include <sys/types.h>

namespace muelle::grader {

/// A process as /proc shows it from outside.
class ProcessStatus {
 public:
  explicit ProcessStatus(pid_t pid) : pid_(pid) {}

  pid_t pid() const { return pid_; }
  /// A field of /proc/PID/status: "CapEff" -> "0000000000000000"; "" when the process has gone.
  std::string field(const std::string& name) const;
  /// "net" -> "net:[4026531840]"; "" when it has gone.
  std::string nameSpace(const std::string& kind) const;
  /// Number -> what it points to.
  std::map<int, std::string> descriptors() const;
  /// Soft and hard limit as in /proc/PID/limits: "Max address space" -> "1073741824 1073741824".
  std::string limits(const std::string& name) const;
  /// Files mapped into its memory.
  std::set<std::string> mappedFiles() const;
  std::string environment() const;
  std::string workingDirectory() const;
  std::string terminal() const;  ///< number of the controlling terminal, "0" for none

 private:
  pid_t pid_;
};

/// Returns when the process has ended, reaped or not.
void waitForEnd(pid_t pid);

/// A process and everything that it has started, itself first.
std::vector<ProcessStatus> familyOf(pid_t ancestor);

/// The one of a family that runs the worker's host program. Throws std::runtime_error when there is none.
ProcessStatus hostOf(pid_t sandbox);

}  // namespace muelle::grader
