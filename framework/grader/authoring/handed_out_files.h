#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace muelle::grader {

/// What of a checkout goes to students.
struct HandedOutFiles {
  std::vector<std::string> files;  ///< relative to the checkout, sorted
  std::vector<std::string> notes;  ///< what is left out or not as committed, one line each
};

/// The rooms that are everyone's (as CMakeLists.txt lists them), the command without app/instructor, every exercise
/// that has a manifest, and what builds them. Hidden files and links are left out; in a git checkout, files that git
/// does not know, too: an author's drafts are not for students.
HandedOutFiles handedOutFiles(const std::filesystem::path& checkout);

}  // namespace muelle::grader
