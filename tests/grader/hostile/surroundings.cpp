#include "surroundings.h"

#include "base/build_paths.h"
#include "support/eventually.h"

#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// What the attacks try to leave, wherever they get to.
constexpr const char* droppedNames[] = {"dropped", "results.json", "shadowed", "plugin.so"};
constexpr const char* attackedFolders[] = {"/", "/tmp", "/dev/shm", "/var/tmp", "/autograder/results"};
constexpr const char* ipcKey = "4711";  // of the attacks' message queue and shared memory

bool hasChildren() {
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
  return waitpid(-1, nullptr, WNOHANG) == 0;  // -1 when there is none
}

/// A process that its sandbox has left behind has become our own child; the sandbox needs a moment to go.
std::string processesThatStay() {
  return eventually([] { return !hasChildren(); }) ? "" : "a process is left behind\n";
}

std::string ipcObjects() {
  std::string text;
  for (const char* kind : {"shm", "msg", "sem"}) {
    std::ifstream table(std::string("/proc/sysvipc/") + kind);
    for (std::string line; std::getline(table, line);) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == ipcKey) text += std::string("an IPC object is left: ") + kind + '\n';
    }
  }
  return text;
}

/// In folders that everybody writes to, only what a confined user owns or an attack names is its work.
std::string droppedFiles() {
  std::string text;
  for (const char* folder : attackedFolders) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      struct stat info {};
      if (lstat(entry.path().c_str(), &info) != 0) continue;
      const std::string name = entry.path().filename();
      bool dropped = isUnassigned(info.st_uid) && !name.starts_with("muelle-");  // staging folders of running workers
      for (const char* attacked : droppedNames) dropped = dropped || name == attacked;
      if (dropped) text += entry.path().string() + " was left\n";
    }
  }
  return text;
}

std::string difference(const std::string& where, const auto& before, const auto& now) {
  if (before == now) return "";
  return "the content of " + where + " has changed\n";
}

}  // namespace

bool isUnassigned(unsigned userId) { return userId >= 2'000'000 && userId < 2'000'000 + 4'194'304; }

Surroundings::Surroundings(fs::path submission) : submission_(std::move(submission)) {
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);  // orphans among our descendants become our children
  submitted_ = wholeFolder(submission_);
  const char* home = std::getenv("HOME");
  for (const fs::path& folder : {fs::path(build_paths::source), fs::path(home != nullptr ? home : "/"),
                                 fs::path(build_paths::source) / "tests" / "hidden", fs::current_path()}) {
    names_.emplace(folder, names(folder));
  }
}

std::string Surroundings::changes() const {
  std::string text = processesThatStay() + ipcObjects() + droppedFiles();
  text += difference(submission_.string(), submitted_, wholeFolder(submission_));
  for (const auto& [folder, before] : names_) text += difference(folder.string(), before, names(folder));
  return text;
}

Surroundings::Listing Surroundings::wholeFolder(const fs::path& folder) {
  Listing listing;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
    struct stat info {};
    lstat(entry.path().c_str(), &info);
    listing[entry.path()] = std::to_string(info.st_size) + " " + std::to_string(info.st_mtim.tv_sec) + "." +
                            std::to_string(info.st_mtim.tv_nsec) + " " + std::to_string(info.st_mode);
  }
  return listing;
}

std::set<std::string> Surroundings::names(const fs::path& folder) {
  std::set<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) found.insert(entry.path().filename());
  return found;
}

}  // namespace muelle::grader
