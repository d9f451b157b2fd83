#pragma once
#include "base/process/descriptor.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace muelle {

/// Whether a file that is written also survives that the power goes: else it may be found empty. It costs a disk's
/// turn.
enum class Durable { No, Yes };

/// Writes a file whole or not at all: into a temporary neighbour, then renamed over `file`.
/// Throws std::runtime_error with the name and the system's reason.
void writeFile(const std::filesystem::path& file, std::string_view text, Durable durable = Durable::No);

/// The bytes of a file. Throws std::runtime_error with the name and the system's reason.
std::string readFile(const std::filesystem::path& file);

/// The same of a file that may not be there, or go while it is read, as those of a process in /proc: nullopt then.
std::optional<std::string> tryReadFile(const std::filesystem::path& file);

/// A fresh folder inside `parent` (made when missing), removed with all it holds at the end of its scope. No two are
/// one, whoever shares `parent`: the name is drawn at random, for other containers have the same process numbers.
class TemporaryFolder {
 public:
  /// Throws std::runtime_error when the folder cannot be made.
  explicit TemporaryFolder(const std::filesystem::path& parent);
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor alive_;  ///< locked as long as we live: removeAbandonedFolders() leaves the folder alone
};

/// Removes the temporary folders in `parent` of processes that were killed: older than `age`, and nobody's.
void removeAbandonedFolders(const std::filesystem::path& parent, std::chrono::seconds age = std::chrono::minutes(10));

}  // namespace muelle
