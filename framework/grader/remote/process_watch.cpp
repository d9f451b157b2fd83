#include "grader/remote/process_watch.h"

#include "base/file.h"

#include <unistd.h>
#include <fstream>
#include <string>

namespace muelle::grader {

namespace {

/// The only child of a process, 0 when it has none or several.
pid_t onlyChild(pid_t pid) {
  std::ifstream stream("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children");
  pid_t child = 0;
  pid_t second = 0;
  stream >> child >> second;
  return second == 0 ? child : 0;
}

/// "S" sleeps, "T" is stopped, "D" waits for a disk, "R" runs; see proc(5).
char stateOf(pid_t pid) {
  const std::string stat = tryReadFile("/proc/" + std::to_string(pid) + "/stat").value_or("");
  const std::size_t name = stat.rfind(')');  // the name may hold anything
  return name != std::string::npos && name + 2 < stat.size() ? stat[name + 2] : '?';
}

}  // namespace

ProcessWatch::ProcessWatch(pid_t outermost) : pid_(outermost) {
  while (const pid_t child = onlyChild(pid_)) pid_ = child;
  if (clock_getcpuclockid(pid_, &clock_) != 0) pid_ = 0;
}

std::chrono::nanoseconds ProcessWatch::cpu() const {
  timespec time{};
  if (pid_ > 0 && clock_gettime(clock_, &time) == 0) {
    lastCpu_ = std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }
  return lastCpu_;
}

std::size_t ProcessWatch::residentBytes() const {
  std::ifstream stream("/proc/" + std::to_string(pid_) + "/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  stream >> total >> resident;
  return stream ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void ProcessWatch::forgetSleep() { looks_ = 0; }

void ProcessWatch::observe() {
  if (pid_ <= 0 || stateOf(pid_) != 'S') return forgetSleep();
  const std::chrono::nanoseconds now = cpu();
  if (looks_ == 0 || now != cpuAtSleep_) {
    looks_ = 0;
    cpuAtSleep_ = now;
    asleepSince_ = Clock::now();
  }
  ++looks_;
}

bool ProcessWatch::sleptFor(std::chrono::milliseconds span) const {
  constexpr int fewestLooks = 8;
  return looks_ >= fewestLooks && Clock::now() - asleepSince_ >= span;
}

}  // namespace muelle::grader
