#include "grader/sandbox/sandbox.h"

#include "grader/sandbox/bubblewrap.h"
#include "grader/sandbox/landlock.h"
#include "grader/sandbox/unsafe.h"

#include <stdexcept>

namespace muelle::grader {

SandboxChoice parseSandboxChoice(const std::string& text) {
  if (text.empty() || text == "auto") return SandboxChoice::Automatic;
  if (text == "bubblewrap") return SandboxChoice::Bubblewrap;
  if (text == "landlock") return SandboxChoice::Landlock;
  if (text == "unsafe") return SandboxChoice::Unsafe;
  throw std::runtime_error("unknown sandbox '" + text + "': choose auto, bubblewrap, landlock or unsafe");
}

std::string toText(SandboxChoice choice) {
  switch (choice) {
    case SandboxChoice::Bubblewrap:
      return "bubblewrap";
    case SandboxChoice::Landlock:
      return "landlock";
    case SandboxChoice::Unsafe:
      return "unsafe";
    case SandboxChoice::Automatic:
      break;
  }
  return "auto";
}

std::unique_ptr<Sandbox> makeSandbox(SandboxChoice choice) {
  if (choice == SandboxChoice::Unsafe) return std::make_unique<Unsafe>();
  std::string reasons;
  if (choice == SandboxChoice::Automatic || choice == SandboxChoice::Bubblewrap) {
    reasons = Bubblewrap::whyNot();
    if (reasons.empty()) return std::make_unique<Bubblewrap>();
  }
  if (choice == SandboxChoice::Automatic || choice == SandboxChoice::Landlock) {
    const std::string reason = Landlock::whyNot();
    if (reason.empty()) return std::make_unique<Landlock>(reasons);
    reasons += (reasons.empty() ? "" : "; ") + reason;
  }
  throw std::runtime_error(
      "no sandbox works here: " + reasons +
      ". Allow user namespaces or Landlock on this machine, or use --unsafe for files of your own");
}

std::unique_ptr<Sandbox> settledSandbox(SandboxChoice choice) {
  if (choice == SandboxChoice::Bubblewrap) return std::make_unique<Bubblewrap>();
  if (choice == SandboxChoice::Landlock) return std::make_unique<Landlock>();
  return makeSandbox(choice);
}

Child Sandbox::start(const Confinement& confinement) const {
  const Prepared prepared = prepare(confinement);
  Child child(prepared.spec);
  child.keep(prepared.keepAlive);
  return child;
}

CommandResult Sandbox::run(const Confinement& confinement, const Capture& capture) const {
  const Prepared prepared = prepare(confinement);
  return runCommand(prepared.spec, capture);
}

unsigned unassignedUserId() {
  constexpr unsigned first = 2'000'000;
  constexpr unsigned count = 4'194'304;  // the kernel's largest process id
  return first + static_cast<unsigned>(getpid()) % count;
}

}  // namespace muelle::grader
