#include "grader/sandbox/bubblewrap.h"

#include "grader/sandbox/handover.h"
#include "grader/sandbox/staging.h"

#include <sys/stat.h>
#include <stdexcept>

namespace muelle::grader {

namespace {

constexpr const char* program = "/usr/bin/bwrap";

/// Debian keeps /bin and /lib as links into /usr; the loader's path in every program goes through /lib64.
void addSystemLinks(std::vector<std::string>& command) {
  for (const char* name : {"bin", "lib", "lib64"}) {
    append(command, {"--symlink", std::string("usr/") + name, std::string("/") + name});
  }
}

void addEnvironment(std::vector<std::string>& command, const std::vector<std::string>& environment) {
  for (const std::string& entry : environment) {
    const std::size_t sign = entry.find('=');
    append(command, {"--setenv", entry.substr(0, sign), entry.substr(sign + 1)});
  }
}

}  // namespace

Sandbox::Prepared Bubblewrap::prepare(const Confinement& confinement) const {
  Prepared prepared;
  ChildSpec& spec = prepared.spec;
  spec.command = unprivilegedPrefix();
  append(spec.command, {program, "--unshare-all", "--die-with-parent", "--new-session", "--clearenv", "--setenv",
                        "PATH", "/usr/bin", "--chdir", "/", "--hostname", "muelle"});
  addEnvironment(spec.command, confinement.environment);
  addSystemLinks(spec.command);
  for (const std::string& folder : confinement.systemFolders) append(spec.command, {"--ro-bind", folder, folder});
  // Before the folders: one of them may lie in our own /tmp, and keep its name.
  if (confinement.scratchBytes > 0) {
    append(spec.command, {"--size", std::to_string(confinement.scratchBytes), "--tmpfs", "/tmp"});
  }
  for (const auto& [ours, inside] : confinement.renamedFolders) append(spec.command, {"--ro-bind", ours, inside});
  spec.descriptors = confinement.descriptors;
  int number = firstHandoverDescriptor;
  for (const VisibleFile& file : confinement.files) {
    if (isSystemFile(file)) {  // everybody may read it: nothing to copy at every start
      append(spec.command, {"--ro-bind", file.source.string(), file.inside});
      continue;
    }
    prepared.handedOver.push_back(openForHandover(file));
    spec.descriptors[number] = prepared.handedOver.back().get();
    append(spec.command,
           {"--perms", file.executable ? "0555" : "0444", "--ro-bind-data", std::to_string(number++), file.inside});
  }
  append(spec.command, {"--remount-ro", "/", "--"});
  spec.command.insert(spec.command.end(), confinement.command.begin(), confinement.command.end());
  spec.limits = confinement.limits;
  return prepared;
}

std::string Bubblewrap::whyNot() {
  struct stat info {};
  if (stat(program, &info) != 0) return "bubblewrap is not installed (apt-get install bubblewrap)";
  try {
    Confinement trial;
    trial.command = {"/usr/bin/true"};
    trial.systemFolders = {"/usr/bin", "/usr/lib"};
    if (std::filesystem::exists("/usr/lib64")) trial.systemFolders.emplace_back("/usr/lib64");
    Pipe err = makePipe();
    trial.descriptors[2] = err.write.get();
    Child child = Bubblewrap().start(trial);
    err.write.reset();
    const auto status = child.wait(std::chrono::steady_clock::now() + std::chrono::seconds(10));
    if (status && !status->signalled && status->code == 0) return "";
    return "bubblewrap cannot make its namespaces here (" + readMessage(err.read.get(), 300) + ")";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace muelle::grader
