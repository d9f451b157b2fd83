#include "course/check/public_parts.h"

#include "base/file.h"
#include "base/process/child.h"
#include "base/process/descriptor.h"
#include "base/text/printable.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sstream>
#include <stdexcept>

namespace muelle {

namespace fs = std::filesystem;

namespace {

/// The objects that the exercise's list names are all there.
bool areBuilt(const fs::path& list) {
  std::istringstream lines(readFile(list));
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".o") && !fs::exists(line)) return false;
  }
  return true;
}

/// The lock of the launcher, which locks this file's descriptor in the same way; waits for it.
Descriptor lockBuild(const fs::path& build) {
  Descriptor lock(::open((build / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock.get() < 0 || ::flock(lock.get(), LOCK_EX) != 0) {
    throw std::runtime_error(fmt::format("cannot lock {}", (build / ".lock").string()));
  }
  return lock;
}

/// The first line that speaks of an error, else the last one.
std::string firstError(const std::string& words) {
  std::istringstream lines(words);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error") != std::string::npos) return line;
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

void buildPublicParts(const fs::path& build, const std::string& topic) {
  const fs::path list = build / "check" / (topic + ".parts");
  if (!fs::exists(list) || areBuilt(list)) return;
  const Descriptor lock = lockBuild(build);
  ChildSpec make;
  make.command = {"cmake", "--build", build.string(), "--target", "public_" + topic};
  make.inheritsEnvironment = true;
  constexpr std::size_t mebibyte = 1 << 20;
  const CommandResult made = runCommand(make, {std::chrono::minutes(10), mebibyte, 0, 0, true});
  if (made.status.success() && !made.timedOut) return;
  throw std::runtime_error(
      fmt::format("the public tests of {} cannot be built: {}", topic, printableLine(firstError(made.out))));
}

}  // namespace muelle
