#pragma once
#include "base/process/child.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace muelle::grader {

/// A file as a confined program sees it: read-only, under a name of its own.
struct VisibleFile {
  std::string inside;            ///< absolute path in the sandbox
  std::filesystem::path source;  ///< file on our side, or
  std::string content;           ///< its text, when `source` is empty
  bool executable = false;
};

/// What a confined program is and sees; everything else is absent: no network, no /proc, no /dev, no environment,
/// no terminal, no other process. It starts in its root folder; paths below that are best given relative to it, because
/// the weaker backends cannot make it "/".
struct Confinement {
  std::vector<std::string> command;  ///< paths inside
  std::vector<VisibleFile> files;
  std::vector<std::string> environment;               ///< "NAME=value", and nothing else but PATH
  std::vector<std::string> systemFolders;             ///< seen read-only under their own names: "/usr/include"
  std::map<std::string, std::string> renamedFolders;  ///< ours -> inside, seen read-only
  std::size_t scratchBytes = 0;                       ///< size of a writable /tmp; 0: none
  std::map<int, int> descriptors;                     ///< number inside -> ours
  ResourceLimits limits;
};

/// Which backends may be used.
enum class SandboxChoice {
  Automatic,   ///< bubblewrap, else Landlock; else an error that says what to install or allow
  Bubblewrap,  ///< that or an error
  Landlock,    ///< own user id, Landlock, seccomp, limits: weaker
  Unsafe,      ///< limits only: for an author's own files
};

/// A way to confine a program.
class Sandbox {
 public:
  virtual ~Sandbox() = default;

  /// Starts a confined program; its first system call has not necessarily happened. Throws std::runtime_error when the
  /// sandbox refuses: the grader's fault, never the student's.
  Child start(const Confinement& confinement) const;
  /// Runs one to its end, with both outputs drained and cut.
  CommandResult run(const Confinement& confinement, const Capture& capture) const;
  /// For the report: "bubblewrap", or a weaker way and why.
  virtual std::string description() const = 0;
  /// The choice that makes this very backend again.
  virtual SandboxChoice choice() const = 0;

 protected:
  /// What has to be started, and what must stay open until it is.
  struct Prepared {
    ChildSpec spec;
    std::vector<Descriptor> handedOver;
    std::shared_ptr<void> keepAlive;  ///< a folder to remove, when the backend made one
  };
  virtual Prepared prepare(const Confinement& confinement) const = 0;
};

/// Reads "auto", "bubblewrap", "landlock", "unsafe"; throws std::runtime_error otherwise.
SandboxChoice parseSandboxChoice(const std::string& text);
std::string toText(SandboxChoice choice);

/// The best backend that works on this machine (tried, not guessed) within the choice.
/// Throws std::runtime_error with what to do when there is none.
std::unique_ptr<Sandbox> makeSandbox(SandboxChoice choice);

/// The backend of a choice that makeSandbox() has settled, without trying it again: for the many processes of one run.
std::unique_ptr<Sandbox> settledSandbox(SandboxChoice choice);

/// A user and group id that belongs to nobody, for a confined program when the grader is root: 2 000 000 and above,
/// different for processes that run at the same time.
unsigned unassignedUserId();

}  // namespace muelle::grader
