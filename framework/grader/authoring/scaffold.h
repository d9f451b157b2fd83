#pragma once
#include "grader/authoring/leaks.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::grader {

/// All files of a new exercise, path -> text: a small one that is complete, so that it builds at once; two tests, one
/// of the public and one of the hidden ones, fail until they are taken out. Throws std::invalid_argument, one line, for
/// a name that is none (a-z, digits and single _ between them) or taken.
Tree scaffoldOf(const std::filesystem::path& checkout, const std::string& topic);

/// Writes the four folders of the exercise, all or none. Throws std::runtime_error when one cannot be written.
void writeScaffold(const std::filesystem::path& checkout, const std::string& topic, const Tree& files);

/// The folders of an exercise, relative to the checkout.
std::vector<std::filesystem::path> foldersOf(const std::string& topic);

}  // namespace muelle::grader
