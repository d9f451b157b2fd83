#pragma once
#include "course/manifest.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace muelle::grader {

/// Bounds of what is read of a submission.
struct IntakeLimits {
  std::size_t sourceBytes = 256 * 1024;         ///< one source file
  std::size_t archiveBytes = 32 * 1024 * 1024;  ///< an archive file, and all that is unpacked, inner archives included
  std::size_t entries = 10'000;                 ///< entries of archives and folders looked at
  std::size_t notes = 20;                       ///< notes kept; the rest are counted
};

/// topic -> file name ("spring_1d.cpp") -> content
using SourcesByTopic = std::map<std::string, std::map<std::string, std::string>>;

/// The files of one submission that count, as text in memory: nothing of it is written to disk here. A topic stands in
/// `sources` when something of it counts, and otherwise in one of `faults`, `refused` and `missing`; all that is said
/// is one printable line.
struct Submission {
  std::filesystem::path path;  ///< absolute
  std::string name;
  SourcesByTopic sources;  ///< UTF-8 or as handed in
  /// topic -> how its files were taken, where that is not as asked for: "spring_1d.cpp is taken from 'spring_1d
  /// (1).cpp'"
  std::map<std::string, std::string> taken;
  /// topic -> handedOutHash() of each TOPIC.h that lies in the exercise's folder; none of them is used
  std::map<std::string, std::set<std::uint64_t>> contracts;
  /// topic -> why its file was refused (too large, a link, a FIFO, no text, two that differ ...): no points
  std::map<std::string, std::string> refused;
  /// topic -> which file is not there, and which may be meant: "no spring_1d.cpp; is 'resorte.cpp' meant?"
  std::map<std::string, std::string> missing;
  /// topic -> why this machine could not read what may be its file (permissions, a failing disk): no verdict, no score
  std::map<std::string, std::string> faults;
  /// What was taken from elsewhere or ignored, one line each, untrusted names made printable.
  std::vector<std::string> notes;
  /// The files of the archive that was handed in, as paths in it; none of a folder. Untrusted text.
  std::vector<std::vector<std::string>> archived;
  /// SHA-256 of `sources`: two submissions with one hash are graded alike.
  std::string hash;
};

/// Takes the files that the manifests name, each as a regular file, not a link: TOPIC/FILE at any depth of enclosing
/// folders, or FILE flat, or else what is near to that name (see isNearName), which is said. `path` is a folder, an
/// archive (zip, tar and its compressions, 7z) or a bare source; archives inside are opened one level deep. Everything
/// else is ignored and said so.
///
/// `only`, unless it is empty, are the topics that are asked for: the others are recognised, and nothing is said of
/// them. It reads everything once; what is saved there afterwards changes nothing.
/// `stubs`: the files as they are handed out; one that is still so counts only where there is no other.
///
/// Throws std::runtime_error (what, where, what to do) when `path` is none of these or cannot be read, or an archive is
/// broken, encrypted or too large.
Submission takeSubmission(const std::filesystem::path& path, const std::vector<Manifest>& course,
                          const IntakeLimits& limits = {}, const std::vector<std::string>& only = {},
                          const SourcesByTopic& stubs = {});

/// The same for a hand-in of several files or folders side by side, as Moodle gives them. What is neither a source nor
/// an archive is ignored among several. Takes its name and path from the first.
Submission takeSubmission(const std::vector<std::filesystem::path>& parts, const std::vector<Manifest>& course,
                          const IntakeLimits& limits = {}, const std::vector<std::string>& only = {},
                          const SourcesByTopic& stubs = {});

}  // namespace muelle::grader
