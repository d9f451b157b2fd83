#pragma once
#include "grader/sandbox/sandbox.h"

namespace muelle::grader {

/// The weaker confinement for machines where bubblewrap may make no namespaces (many containers): a user id that
/// belongs to nobody when the grader is root, Landlock for files, a filter that denies network and IPC, limits.
///
/// Landlock hides no names: a confined program can still ask whether a path exists and how large a file is. The files
/// themselves, and everything that is written, stay out of reach. The files of the confinement are copied into a
/// private folder that goes away with the process.
class Landlock : public Sandbox {
 public:
  /// \param reason why the stronger sandbox is not used, for the report
  explicit Landlock(std::string reason = "") : reason_(std::move(reason)) {}

  std::string description() const override;
  SandboxChoice choice() const override { return SandboxChoice::Landlock; }

  /// "" when it works on this machine, else one line that says why not.
  static std::string whyNot();

 protected:
  Prepared prepare(const Confinement& confinement) const override;

 private:
  std::string reason_;
};

}  // namespace muelle::grader
