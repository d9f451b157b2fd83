#include "grader/run/store.h"

#include "base/file.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>
#include <vector>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

struct Kept {
  fs::path file;
  fs::file_time_type used;
  std::uintmax_t bytes;
};

std::vector<Kept> keptBelow(const fs::path& folder) {
  std::vector<Kept> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone)) continue;
    const auto used = entry->last_write_time(gone);
    const auto bytes = entry->file_size(gone);
    if (!gone) files.push_back({entry->path(), used, bytes});
  }
  return files;
}

}  // namespace

std::string cannotKeep(std::string_view what, const fs::path& folder, const std::error_code& error) {
  return fmt::format("cannot keep {} in {}: {}; mend that folder, or name another with MUELLE_KEPT", what,
                     folder.string(), error.message());
}

fs::path Store::file(std::string_view key, std::string_view suffix) const {
  // Two letters of the key as a folder: no folder gets a hundred thousand names.
  return folder_ / key.substr(0, 2) / (std::string(key) + std::string(suffix));
}

bool Store::has(std::string_view key, std::string_view suffix) const {
  std::error_code error;
  return fs::is_regular_file(file(key, suffix), error);
}

std::optional<std::string> Store::read(std::string_view key, std::string_view suffix) const {
  const fs::path path = file(key, suffix);
  if (!has(key, suffix)) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return tryReadFile(path);
}

void Store::write(std::string_view key, std::string_view suffix, std::string_view content) const {
  const fs::path path = file(key, suffix);
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw std::runtime_error(cannotKeep("results", folder_, error));
  writeFile(path, content);
}

void Store::remove(std::string_view key, std::string_view suffix) const {
  std::error_code ignored;
  fs::remove(file(key, suffix), ignored);
}

std::uintmax_t Store::prune(std::uintmax_t bytes) const {
  std::vector<Kept> files = keptBelow(folder_);
  std::uintmax_t total = 0;
  for (const Kept& kept : files) total += kept.bytes;
  std::sort(files.begin(), files.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  std::uintmax_t removed = 0;
  for (const Kept& kept : files) {
    if (total - removed <= bytes) break;
    std::error_code ignored;
    if (fs::remove(kept.file, ignored)) removed += kept.bytes;
  }
  return removed;
}

}  // namespace muelle::grader
