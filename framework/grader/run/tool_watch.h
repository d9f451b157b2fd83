#pragma once
#include "base/process/descriptor.h"
#include "grader/sandbox/sandbox.h"

#include <string>

namespace muelle::grader {

/// Sees how each process of compiler and linker ends, by its wait status: what the driver says of it, a submission can
/// make a compiler say, too.
///
/// In the sandbox a script stands between the driver and its tools (cc1plus, as, the linker). It writes each tool's
/// status to a descriptor that nothing else writes to, and ends as the tool has ended. What leaves no status was killed
/// before it could.
class ToolWatch {
 public:
  /// Throws std::runtime_error when the system has no memory left for it.
  ToolWatch();

  /// Shows the script and lends the descriptor to what is going to be confined.
  void addTo(Confinement& confinement) const;

  /// Words for the shell that have one command watched, and flags that have a driver's tools watched.
  static std::string command();
  static std::string compilerFlag();
  static std::string linkerFlag();

  /// Of a run that has failed: true when a tool has ended by itself, with an error or by a signal that its own work
  /// draws, and none by another's signal.
  bool sawOwnFailure() const;

 private:
  Descriptor statuses_;
};

}  // namespace muelle::grader
