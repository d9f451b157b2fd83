#include "hunter.h"

#include "base/file.h"

#include <signal.h>
#include <sys/types.h>
#include <unistd.h>
#include <filesystem>
#include <map>
#include <set>

namespace muelle::grader {

namespace {

struct Process {
  std::string name;
  pid_t parent = 0;
};

/// "17 (cc1plus) R 12 ...": the name may hold anything, blanks and brackets too.
bool readProcess(const std::filesystem::path& folder, Process& process) {
  const std::string text = tryReadFile(folder / "stat").value_or("");  // it may end while it is read
  const std::size_t open = text.find('(');
  const std::size_t close = text.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close + 4 > text.size()) return false;
  process.name = text.substr(open + 1, close - open - 1);
  process.parent = static_cast<pid_t>(std::atol(text.c_str() + close + 4));
  return true;
}

std::map<pid_t, Process> allProcesses() {
  std::map<pid_t, Process> processes;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    Process process;
    if (readProcess(entry->path(), process)) processes[static_cast<pid_t>(std::stol(name))] = process;
  }
  return processes;
}

bool descends(const std::map<pid_t, Process>& processes, pid_t pid) {
  for (auto found = processes.find(pid); found != processes.end(); found = processes.find(found->second.parent)) {
    if (found->second.parent == getpid()) return true;
  }
  return false;
}

}  // namespace

Hunter::Hunter(std::string name, int signal, int most)
    : name_(name.substr(0, 15)), signal_(signal), most_(most), thread_([this] { hunt(); }) {}

Hunter::~Hunter() {
  ends_ = true;
  thread_.join();
}

void Hunter::hunt() {
  std::set<pid_t> hit;  // each once: a stopped process is still there
  while (!ends_ && hits_ < most_) {
    const std::map<pid_t, Process> processes = allProcesses();
    for (const auto& [pid, process] : processes) {
      if (process.name != name_ || hit.contains(pid) || !descends(processes, pid)) continue;
      if (kill(pid, signal_) == 0) ++hits_;
      hit.insert(pid);
    }
    std::this_thread::yield();
  }
}

}  // namespace muelle::grader
