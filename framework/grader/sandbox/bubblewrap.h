#pragma once
#include "grader/sandbox/sandbox.h"

namespace muelle::grader {

/// Confinement by bubblewrap: namespaces of its own for users, mounts, processes, network, IPC and host name; when the
/// grader is root, started through setpriv under a user id that belongs to nobody.
///
/// Files are handed over as descriptors and copied into the sandbox's memory, so that no folder of the project needs to
/// be readable for that user and nothing of the project can be reached from inside.
class Bubblewrap : public Sandbox {
 public:
  std::string description() const override { return "bubblewrap"; }
  SandboxChoice choice() const override { return SandboxChoice::Bubblewrap; }

  /// "" when it works on this machine, else one line that says why not.
  static std::string whyNot();

 protected:
  Prepared prepare(const Confinement& confinement) const override;
};

}  // namespace muelle::grader
