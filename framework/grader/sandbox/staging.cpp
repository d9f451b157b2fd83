#include "grader/sandbox/staging.h"

#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

/// "/contract/spring_1d.h" -> "contract/spring_1d.h"
fs::path relative(const std::string& inside) { return fs::path(inside).relative_path(); }

void give(const fs::path& path, int owner) {
  if (owner < 0) return;
  const auto id = static_cast<uid_t>(owner);
  if (chown(path.c_str(), id, id) != 0) {
    throw std::runtime_error("cannot give " + path.string() + " away: " + std::strerror(errno));
  }
}

}  // namespace

bool isSystemFile(const VisibleFile& file) {
  if (file.source.empty()) return false;
  std::error_code error;
  const fs::path real = fs::canonical(file.inside, error);
  return !error && real == fs::canonical(file.source);
}

StagingFolder::StagingFolder(const Confinement& confinement, int owner) {
  std::string name = (fs::temp_directory_path() / "muelle-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder in " + name);
  path_ = name;
  try {
    for (const VisibleFile& file : confinement.files) {
      if (!isSystemFile(file)) add(relative(file.inside), file);
    }
    for (const auto& [ours, inside] : confinement.renamedFolders)
      fs::create_directory_symlink(ours, path_ / relative(inside));
    if (confinement.scratchBytes > 0) {
      fs::create_directory(scratch());
      fs::permissions(scratch(), fs::perms::owner_all);
      give(scratch(), owner);
    }
    give(path_, owner);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    throw;
  }
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void StagingFolder::add(const fs::path& name, const VisibleFile& file) const {
  const fs::path target = path_ / name;
  fs::create_directories(target.parent_path());
  if (!file.source.empty()) {
    fs::copy_file(file.source, target);
  } else {
    std::ofstream stream(target, std::ios::binary);
    stream << file.content;
    stream.close();
    if (!stream) throw std::runtime_error("cannot write " + target.string() + ": " + std::strerror(errno));
  }
  using fs::perms;
  const perms readable = perms::owner_read | perms::group_read | perms::others_read;
  const perms executable = perms::owner_exec | perms::group_exec | perms::others_exec;
  fs::permissions(target, file.executable ? readable | executable : readable);
}

}  // namespace muelle::grader
