#include "grader/sandbox/landlock.h"

#include "base/build_paths.h"
#include "grader/sandbox/handover.h"
#include "grader/sandbox/staging.h"

#include <algorithm>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

fs::path helper() { return fs::path(build_paths::binary) / "bin" / "muelle-confine"; }

constexpr const char* stagedHelper = "muelle-confine";

}  // namespace

std::string Landlock::description() const {
  const std::string weaker =
      "landlock (weaker than bubblewrap: no namespaces, so a submission shares the machine's process and user tables, "
      "and "
      "can ask which files exist, though it can open none)";
  return reason_.empty() ? weaker : weaker + ": " + reason_;
}

Sandbox::Prepared Landlock::prepare(const Confinement& confinement) const {
  const bool root = geteuid() == 0;
  const auto staging = std::make_shared<StagingFolder>(confinement, root ? static_cast<int>(unassignedUserId()) : -1);
  staging->add(stagedHelper, {"", helper(), "", true});  // the build folder may be closed to the other user
  Prepared prepared;
  ChildSpec& spec = prepared.spec;
  spec.command = unprivilegedPrefix();
  append(spec.command, {(staging->path() / stagedHelper).string(), "--read", staging->path().string()});
  for (const VisibleFile& file : confinement.files) {
    if (isSystemFile(file)) append(spec.command, {"--read", fs::canonical(file.source).string()});
  }
  for (const std::string& folder : confinement.systemFolders) append(spec.command, {"--read", folder});
  for (const auto& [ours, inside] : confinement.renamedFolders) append(spec.command, {"--read", ours});
  if (confinement.scratchBytes > 0) append(spec.command, {"--write", staging->scratch().string()});
  append(spec.command, {"--"});
  spec.command.insert(spec.command.end(), confinement.command.begin(), confinement.command.end());
  spec.descriptors = confinement.descriptors;
  spec.environment = confinement.environment;
  append(spec.environment, {"PATH=/usr/bin", "TMPDIR=" + staging->scratch().string()});
  spec.limits = confinement.limits;
  constexpr unsigned mostProcesses = 64;  // counted by user id, so only where that is nobody else's
  if (root && spec.limits.processes == 0) spec.limits.processes = mostProcesses;
  spec.workingDirectory = staging->path();
  prepared.keepAlive = staging;
  return prepared;
}

std::string Landlock::whyNot() {
  if (!fs::exists(helper())) return "the program " + helper().string() + " has not been built";
  try {
    Confinement trial;
    trial.command = {"/usr/bin/true"};
    trial.systemFolders = {"/usr/bin", "/usr/lib"};
    if (fs::exists("/usr/lib64")) trial.systemFolders.emplace_back("/usr/lib64");
    const CommandResult result = Landlock().run(trial, {std::chrono::seconds(10), 1000, 1000, 0, false});
    if (!result.timedOut && !result.status.signalled && result.status.code == 0) return "";
    std::string words = result.err.substr(0, 300);
    std::replace(words.begin(), words.end(), '\n', ' ');
    return "Landlock refuses (" + words + ")";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace muelle::grader
