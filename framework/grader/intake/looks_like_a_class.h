#pragma once
#include "course/manifest.h"
#include "grader/intake/collector.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// Why a folder given as one submission is rather a class, with what to do instead ("holds 28 archives; to grade each
/// as a submission: ./muelle grade --class FOLDER"); nullopt when it is a submission or no folder. A class holds no
/// hand-in itself (no file to hand in, no exercise's folder, no exercises/ or solutions/), and two children or more
/// that are archives, that Moodle or Gradescope has named, or that hold files for one and the same exercise. Several
/// children named after one exercise with numbers (contact-1, contact-2) are students, one alone is a part of a
/// hand-in.
std::optional<std::string> looksLikeAClass(const std::filesystem::path& path, const std::vector<Manifest>& course);

/// The same of an archive given as one submission, by the paths of its files: a note, since one student may hand in two
/// versions so. nullopt when it is a submission.
std::optional<std::string> archiveOfAClass(const std::vector<RelativePath>& files, const std::vector<Manifest>& course);

}  // namespace muelle::grader
