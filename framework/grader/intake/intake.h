#pragma once
#include "course/manifest.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace muelle::grader {

/// Bounds of what is read of a submission.
struct IntakeLimits {
  std::size_t sourceBytes = 256 * 1024;         ///< one source file
  std::size_t archiveBytes = 32 * 1024 * 1024;  ///< the archive file, and all that is unpacked of it
  std::size_t entries = 10'000;                 ///< entries of an archive or folder looked at
  std::size_t notes = 20;                       ///< notes kept; the rest are counted
};

/// The files of one submission that count, as text in memory: nothing of it is written to disk here.
struct Submission {
  std::filesystem::path path;  ///< absolute
  std::string name;
  /// topic -> file name ("spring_1d.cpp") -> content
  std::map<std::string, std::map<std::string, std::string>> sources;
  /// topic -> why its file was refused (too large, a link, a FIFO, twice in the archive ...); absent files have no
  /// entry
  std::map<std::string, std::string> refused;
  /// What was ignored, one line each, untrusted names made printable.
  std::vector<std::string> notes;
};

/// Takes from a folder or an archive (zip, tar and its compressions, 7z) the files that the manifests name:
/// TOPIC/FILE at any depth of enclosing folders, or FILE flat. Only regular files, not links; opened without following
/// links; everything else is ignored and said so. Throws std::runtime_error (what, where, what to do) when `path` is
/// neither a folder nor a readable archive.
Submission takeSubmission(const std::filesystem::path& path, const std::vector<Manifest>& course,
                          const IntakeLimits& limits = {});

}  // namespace muelle::grader
