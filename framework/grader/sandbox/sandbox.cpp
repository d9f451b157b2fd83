#include "grader/sandbox/sandbox.h"

#include "grader/sandbox/bubblewrap.h"

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
  if (choice == SandboxChoice::Automatic || choice == SandboxChoice::Bubblewrap) {
    const std::string reason = Bubblewrap::whyNot();
    if (reason.empty()) return std::make_unique<Bubblewrap>();
    throw std::runtime_error("no sandbox works here: " + reason);
  }
  throw std::runtime_error("no sandbox works here");
}

std::unique_ptr<Sandbox> settledSandbox(SandboxChoice choice) {
  if (choice == SandboxChoice::Bubblewrap) return std::make_unique<Bubblewrap>();
  return makeSandbox(choice);
}

Child Sandbox::start(const Confinement& confinement) const {
  const Prepared prepared = prepare(confinement);
  Child child(prepared.spec);
  child.keep(prepared.keepAlive);
  return child;
}

CommandResult Sandbox::run(const Confinement& confinement, std::chrono::milliseconds limit, std::size_t outBytes,
                           std::size_t errBytes) const {
  const Prepared prepared = prepare(confinement);
  return runCommand(prepared.spec, limit, outBytes, errBytes);
}

unsigned unassignedUserId() {
  constexpr unsigned first = 2'000'000;
  constexpr unsigned count = 4'194'304;  // the kernel's largest process id
  return first + static_cast<unsigned>(getpid()) % count;
}

}  // namespace muelle::grader
