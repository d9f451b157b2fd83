#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace muelle::grader {

/// "cannot keep results in FOLDER: Permission denied; mend that folder, or name another with MUELLE_KEPT"
std::string cannotKeep(std::string_view what, const std::filesystem::path& folder, const std::error_code& error);

/// What the grader keeps between runs, in files named by the key of everything that decided their content: compiled
/// hand-ins, records, curves. Several processes may use it at once: a file appears whole or not at all, and whoever
/// writes a key last writes the same. What a disk has damaged since is its reader's to find out: it is made again.
class Store {
 public:
  explicit Store(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Where a kept file stands. \param suffix ".so", ".json"
  std::filesystem::path file(std::string_view key, std::string_view suffix) const;

  bool has(std::string_view key, std::string_view suffix) const;
  /// nullopt when it is not kept, or this machine cannot read it any more. Marks it as used.
  std::optional<std::string> read(std::string_view key, std::string_view suffix) const;
  /// Throws std::runtime_error when it cannot be written (a full disk); nothing half-written stays.
  void write(std::string_view key, std::string_view suffix, std::string_view content) const;
  void remove(std::string_view key, std::string_view suffix) const;

  /// Removes what has not been used for longest until at most `bytes` are left. Returns the bytes removed. Files that
  /// another process removes meanwhile are no trouble.
  std::uintmax_t prune(std::uintmax_t bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace muelle::grader
