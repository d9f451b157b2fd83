#pragma once
#include "grader/intake/intake.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace muelle::grader {

/// A folder that goes away with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file, folders included, and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// Two exercises, spring_1d and triangle, each with one file named after it.
std::vector<Manifest> smallCourse();

/// One entry of an archive to be made; what libarchive's writer lets through, bad or not.
struct ArchiveEntry {
  std::string name;
  std::string text;
  unsigned type = 0100000;     ///< S_IFREG ...
  std::string symbolicLink{};  ///< target
  std::string hardLink{};      ///< target
};

enum class Format { Zip, Tar, TarGzip, TarBzip2, TarXz, TarZstd, SevenZip, EncryptedZip };

/// Writes an archive with libarchive.
void writeArchive(const std::filesystem::path& file, Format format, const std::vector<ArchiveEntry>& entries);

/// The one line of the std::runtime_error that taking the submission throws; fails the test when it throws none.
std::string refusal(const std::filesystem::path& submission, const IntakeLimits& limits = {});

/// True when a note holds the text.
bool isNoted(const Submission& submission, const std::string& text);

}  // namespace muelle::grader
