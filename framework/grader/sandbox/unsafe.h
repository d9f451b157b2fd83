#pragma once
#include "grader/sandbox/sandbox.h"

namespace muelle::grader {

/// No confinement but limits, an empty environment and the worker's own filter of system calls: for an author's own
/// files, where nothing else runs.
class Unsafe : public Sandbox {
 public:
  std::string description() const override;
  SandboxChoice choice() const override { return SandboxChoice::Unsafe; }

 protected:
  Prepared prepare(const Confinement& confinement) const override;
};

}  // namespace muelle::grader
