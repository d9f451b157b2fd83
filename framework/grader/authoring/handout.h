#pragma once
#include "grader/authoring/leaks.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::grader {

/// A student's tree, to be written.
struct Handout {
  Tree tree;                       ///< path -> text
  std::vector<std::string> notes;  ///< for the instructor, one line each
  std::vector<Leak> leaks;         ///< what must not go out
};

/// Reads a student's tree out of a checkout: handedOutFiles() as they are, but for a README of its own, the one preset
/// that a student needs, and the list of what was handed out, made anew.
Handout readHandout(const std::filesystem::path& checkout);

/// Whether a folder that is not empty may be written.
enum class Replace { No, Yes };

/// Writes the tree into `folder` whole or not at all: beside it under another name, then renamed. What stood there is
/// replaced only when it is a student's tree, too; its `.git` stays. Throws std::runtime_error in one line when the
/// folder is not empty, lies among the course's own files, or cannot be written.
void writeHandout(const Handout& handout, const std::filesystem::path& checkout, const std::filesystem::path& folder,
                  Replace replace);

}  // namespace muelle::grader
