#include "hunter.h"

#include "base/file.h"

#include <signal.h>
#include <sys/types.h>
#include <unistd.h>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

namespace muelle::grader {

namespace {

struct Process {
  std::string name;
  char state = 'X';  // 'T' stopped, 'Z' ended and not yet waited for, 'X' gone
  pid_t parent = 0;

  bool hasEnded() const { return state == 'Z' || state == 'X'; }
};

/// "17 (cc1plus) R 12 ...": the name may hold anything, blanks and brackets too.
bool readProcess(const std::filesystem::path& folder, Process& process) {
  const std::string text = tryReadFile(folder / "stat").value_or("");  // it may end while it is read
  const std::size_t open = text.find('(');
  const std::size_t close = text.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close + 4 > text.size()) return false;
  process.name = text.substr(open + 1, close - open - 1);
  process.state = text[close + 2];
  process.parent = static_cast<pid_t>(std::atol(text.c_str() + close + 4));
  return true;
}

std::set<pid_t> allPids() {
  std::set<pid_t> pids;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.find_first_not_of("0123456789") == std::string::npos) pids.insert(static_cast<pid_t>(std::stol(name)));
  }
  return pids;
}

/// Those that came after `older`: to read the others, again and again, would take a core from what is hunted.
std::map<pid_t, Process> processesSince(const std::set<pid_t>& older) {
  std::map<pid_t, Process> processes;
  for (const pid_t pid : allPids()) {
    Process process;
    if (!older.contains(pid) && readProcess("/proc/" + std::to_string(pid), process) && !process.hasEnded())
      processes[pid] = process;
  }
  return processes;
}

bool descends(const std::map<pid_t, Process>& processes, pid_t pid) {
  for (auto found = processes.find(pid); found != processes.end(); found = processes.find(found->second.parent)) {
    if (found->second.parent == getpid()) return true;
  }
  return false;
}

/// A child that has not yet become another program bears its parent's name.
bool isForkOfItsLike(const std::map<pid_t, Process>& processes, const Process& process) {
  const auto parent = processes.find(process.parent);
  return parent != processes.end() && parent->second.name == process.name;
}

/// Stops it first: a signal to what ends just now is sent without an error and hits nothing, whereas a stopped process
/// does no more than this signal makes it do.
bool hit(pid_t pid, int signal) {
  if (kill(pid, SIGSTOP) != 0) return false;
  Process process;
  do {
    process = {};
    readProcess("/proc/" + std::to_string(pid), process);
    if (process.hasEnded()) return false;
  } while (process.state != 'T');
  if (signal == SIGSTOP) return true;
  const bool wasSent = kill(pid, signal) == 0;
  kill(pid, SIGCONT);  // what is not SIGKILL waits for it
  return wasSent;
}

}  // namespace

Hunter::Hunter(std::string name, int signal, int most)
    : name_(name.substr(0, 15)), signal_(signal), most_(most), older_(allPids()), thread_([this] { hunt(); }) {}

Hunter::~Hunter() {
  end_.release();
  thread_.join();
}

void Hunter::hunt() {
  std::set<pid_t> seen;  // each once: a stopped process is still there
  do {
    const std::map<pid_t, Process> processes = processesSince(older_);
    for (const auto& [pid, process] : processes) {
      if (process.name != name_ || seen.contains(pid) || isForkOfItsLike(processes, process)) continue;
      if (!descends(processes, pid)) continue;
      if (hits_ < most_ && hit(pid, signal_)) ++hits_;
      seen.insert(pid);
    }
    // the pause leaves the core to those that are hunted
  } while (hits_ < most_ && !end_.try_acquire_for(std::chrono::milliseconds(1)));
}

}  // namespace muelle::grader
