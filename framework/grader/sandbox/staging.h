#pragma once
#include "grader/sandbox/sandbox.h"

namespace muelle::grader {

/// A private folder that holds a confinement's files for a program without a view of its own of the file system: it
/// starts in the folder and finds by relative paths what a sandbox with mounts has under "/". Removed with its owner.
class StagingFolder {
 public:
  /// \param owner user and group id that may read the folder and write its tmp/, or -1 for our own
  /// Throws std::runtime_error naming the file that cannot be staged.
  StagingFolder(const Confinement& confinement, int owner);
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path scratch() const { return path_ / "tmp"; }

  /// Adds a file under a name of this folder.
  void add(const std::filesystem::path& name, const VisibleFile& file) const;

 private:
  std::filesystem::path path_;
};

/// True for a file of the system that everybody may read, seen under its own name: nothing to stage.
bool isSystemFile(const VisibleFile& file);

}  // namespace muelle::grader
