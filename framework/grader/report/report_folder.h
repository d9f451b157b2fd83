#pragma once
#include <filesystem>
#include <string>

namespace muelle::grader {

/// A file name made of a submission's: printable, without separators, not hidden, at most 100 bytes; "submission" when
/// nothing is left of it.
std::string fileNameFor(const std::string& name);

/// The folder for the reports of the submission at `submission`, below `parent` and made when missing: its own name,
/// or, when that is another submission's already, the name and eight digits of its path. Two submissions never share
/// one; the same submission gets the same again. Throws std::runtime_error when it cannot be made.
std::filesystem::path reportFolder(const std::filesystem::path& parent, const std::filesystem::path& submission);

}  // namespace muelle::grader
