#include "process_status.h"

#include "base/file.h"
#include "base/text/trim.h"

#include <sched.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

fs::path folder(pid_t pid) { return fs::path("/proc") / std::to_string(pid); }

std::string target(const fs::path& link) {
  std::error_code ignored;
  return fs::read_symlink(link, ignored).string();
}

}  // namespace

std::string ProcessStatus::field(const std::string& name) const {
  std::ifstream stream(folder(pid_) / "status");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(name + ":")) return std::string(trimmed(line.substr(name.size() + 1)));
  }
  return "";
}

std::string ProcessStatus::nameSpace(const std::string& kind) const { return target(folder(pid_) / "ns" / kind); }

std::map<int, std::string> ProcessStatus::descriptors() const {
  std::map<int, std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder(pid_) / "fd", ignored)) {
    found[std::stoi(entry.path().filename())] = target(entry.path());
  }
  return found;
}

std::string ProcessStatus::limits(const std::string& name) const {
  std::ifstream stream(folder(pid_) / "limits");
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(name)) continue;
    std::istringstream words(line.substr(name.size()));
    std::string soft;
    std::string hard;
    words >> soft >> hard;
    return soft + " " + hard;
  }
  return "";
}

std::set<std::string> ProcessStatus::mappedFiles() const {
  std::set<std::string> files;
  std::ifstream stream(folder(pid_) / "maps");
  for (std::string line; std::getline(stream, line);) {
    if (const std::size_t path = line.find('/'); path != std::string::npos) files.insert(line.substr(path));
  }
  return files;
}

std::string ProcessStatus::environment() const { return tryReadFile(folder(pid_) / "environ").value_or(""); }

std::string ProcessStatus::workingDirectory() const { return target(folder(pid_) / "cwd"); }

std::string ProcessStatus::terminal() const {
  const std::string stat = tryReadFile(folder(pid_) / "stat").value_or("");
  std::istringstream words(stat.substr(std::min(stat.rfind(')') + 2, stat.size())));
  std::string state, parent, group, session, terminal;
  words >> state >> parent >> group >> session >> terminal;
  return terminal;
}

void waitForEnd(pid_t pid) {
  for (;;) {
    const std::string state = ProcessStatus(pid).field("State");
    if (state.empty() || state.front() == 'Z' || state.front() == 'X') return;
    sched_yield();
  }
}

std::vector<ProcessStatus> familyOf(pid_t ancestor) {
  std::vector<ProcessStatus> family{ProcessStatus(ancestor)};
  for (std::size_t i = 0; i < family.size(); ++i) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const pid_t pid = std::atoi(entry.path().filename().c_str());
      if (pid > 0 && ProcessStatus(pid).field("PPid") == std::to_string(family[i].pid())) family.emplace_back(pid);
    }
  }
  return family;
}

ProcessStatus hostOf(pid_t sandbox) {
  for (const ProcessStatus& process : familyOf(sandbox)) {
    if (process.field("Name") == "host") return process;
  }
  throw std::runtime_error("no process of the sandbox runs the host program");
}

}  // namespace muelle::grader
