#include "grader/run/clean.h"

#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

std::uintmax_t bytesBelow(const fs::path& path) {
  std::uintmax_t bytes = 0;
  std::error_code error;
  if (fs::is_regular_file(path, error)) return fs::file_size(path, error);
  for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (entry->is_regular_file(gone)) bytes += entry->file_size(gone);
  }
  return bytes;
}

}  // namespace

std::uintmax_t clean(const Workplace& workplace) {
  std::uintmax_t removed = 0;
  if (!fs::exists(workplace.kept)) return removed;
  for (const auto& entry : fs::directory_iterator(workplace.kept)) {
    if (entry.path() == workplace.seedFile()) continue;
    removed += bytesBelow(entry.path());
    std::error_code error;
    fs::remove_all(entry.path(), error);
    if (error) throw std::runtime_error("cannot remove " + entry.path().string() + ": " + error.message());
  }
  return removed;
}

}  // namespace muelle::grader
