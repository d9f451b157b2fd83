#pragma once
#include <sys/types.h>
#include <filesystem>

namespace muelle::grader {

/// A disk of a few megabytes, mounted on a folder for this process and its children alone until it ends.
class SmallDisk {
 public:
  /// \param folder exists and is empty   \param bytes what the disk holds
  SmallDisk(const std::filesystem::path& folder, std::size_t bytes);
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk();

  /// False where this process may mount nothing (it is not root's).
  bool isMounted() const { return isMounted_; }
  /// Fills it until so many bytes are left, and takes that back.
  void fill(std::size_t left) const;
  void empty() const;

 private:
  std::filesystem::path folder_;
  bool isMounted_ = false;
};

}  // namespace muelle::grader
