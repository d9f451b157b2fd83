#include "grader/run/shared_prelude.h"

#include "grader/run/digest.h"

#include <sys/stat.h>
#include <unistd.h>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// Whether a user without rights can get to this file where it is.
bool reachableByAll(const fs::path& file) {
  const auto open = [](const fs::path& path, fs::perms needed) {
    return (fs::status(path).permissions() & needed) == needed;
  };
  if (!open(file, fs::perms::others_read)) return false;
  for (fs::path folder = file.parent_path(); folder != folder.root_path(); folder = folder.parent_path()) {
    if (!open(folder, fs::perms::others_exec)) return false;
  }
  return true;
}

/// A name in a folder that everybody writes may have been taken by somebody else.
bool isOursAlone(const fs::path& folder) {
  struct stat info {};
  if (lstat(folder.c_str(), &info) != 0) return false;
  return S_ISDIR(info.st_mode) && info.st_uid == geteuid() && (info.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

bool isSame(const fs::path& copy, const fs::path& original) {
  std::error_code missing;
  const auto size = fs::file_size(copy, missing);
  if (missing || size != fs::file_size(original)) return false;
  return fs::last_write_time(copy) == fs::last_write_time(original);
}

/// Copies through a neighbour, so that no other process sees half a file.
void copyWhole(const fs::path& original, const fs::path& copy) {
  const fs::path part = copy.string() + "." + std::to_string(getpid());
  fs::copy_file(original, part, fs::copy_options::overwrite_existing);
  fs::permissions(part,
                  fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);
  fs::last_write_time(part, fs::last_write_time(original));
  fs::rename(part, copy);
}

}  // namespace

std::optional<fs::path> sharedPrelude(const Workplace& workplace) {
  const fs::path file = workplace.prelude();
  if (reachableByAll(file)) return file.parent_path();
  if (geteuid() != 0) return file.parent_path();  // the confined program runs under our own user id
  try {
    const std::string name = "muelle-prelude-" + digest({workplace.binary.string()}).substr(0, 16);
    const fs::path folder = fs::temp_directory_path() / name;
    mkdir(folder.c_str(), 0755);
    if (!isOursAlone(folder)) return std::nullopt;
    const fs::path copy = folder / file.filename();
    if (!isSame(copy, file)) copyWhole(file, copy);
    if (reachableByAll(copy)) return folder;
  } catch (const fs::filesystem_error&) {
    // No room for a copy: the header is handed over each time.
  }
  return std::nullopt;
}

}  // namespace muelle::grader
