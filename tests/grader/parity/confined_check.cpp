#include "confined_check.h"

#include "base/build_paths.h"

#include <fmt/format.h>
#include <filesystem>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

Confinement confinementOf(const Manifest& manifest, const Sources& sources) {
  Confinement confinement;
  confinement.command = {MUELLE_CHECK_OUTCOME, manifest.topic, "/tmp/build"};
  for (const std::string& name : manifest.files) {
    const std::string inside = "/submission/" + name;
    confinement.files.push_back({inside, {}, sources.at(name), false});
    confinement.command.push_back(inside);
  }
  confinement.systemFolders = {"/usr/bin", "/usr/lib", "/usr/include"};
  // Where Debian's c++ leads, among others.
  for (const char* folder : {"/usr/lib64", "/etc/alternatives"}) {
    if (fs::exists(folder)) confinement.systemFolders.emplace_back(folder);
  }
  const fs::path checkout = build_paths::source;
  for (const std::string& folder : {(checkout / "framework").string(), (checkout / "exercises").string(),
                                    std::string(build_paths::binary), std::string(build_paths::eigen)}) {
    if (!folder.starts_with("/usr/")) confinement.renamedFolders[folder] = folder;
  }
  confinement.renamedFolders["/proc"] = "/proc";
  confinement.scratchBytes = 512UL << 20U;
  confinement.limits.processes = 64;
  return confinement;
}

}  // namespace

Checked checkConfined(const Sandbox& sandbox, const Manifest& manifest, const Sources& sources) {
  Capture capture;
  capture.limit = std::chrono::minutes(4);
  const CommandResult result = sandbox.run(confinementOf(manifest, sources), capture);
  Checked checked;
  if (result.timedOut || !result.status.success()) {
    checked.trouble = fmt::format("check gave no verdict ({}): {}", result.timedOut ? "too long" : "it ended badly",
                                  result.err.substr(0, 2000));
    return checked;
  }
  const std::size_t line = result.out.find('\n');
  checked.outcome = outcomeNamed(result.out.substr(0, line));
  checked.words = result.out;
  return checked;
}

}  // namespace muelle::grader
