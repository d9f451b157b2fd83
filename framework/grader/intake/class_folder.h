#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace muelle::grader {

/// One submission of a class.
struct ClassEntry {
  /// A folder or a file; several where Moodle gives a student's files side by side.
  std::vector<std::filesystem::path> parts;
  std::string student;       ///< printable and unlike every other entry's: "Ana García (12345)"
  std::string refusal = {};  ///< why it is not taken, though it may be meant: "is a symbolic link: ..."
};

/// What a folder of a class holds.
struct ClassFolder {
  std::vector<ClassEntry> entries;  ///< sorted by student
  std::vector<std::string> notes;   ///< what is no submission, one printable line each
};

/// Lists the children of a folder, each one submission: a folder, an archive, a source alone, or any other file that
/// may be meant as one (taking it says what is wrong with it). Files of one name and number of Moodle's are one
/// submission. Links that may be meant are refused. Hidden files, Moodle's texts typed online, and texts, pictures,
/// grade books and the like that bear no student's mark are noted instead; what systems leave behind (.DS_Store) is not
/// spoken of. Throws std::runtime_error when the folder cannot be read.
ClassFolder listClass(const std::filesystem::path& folder);

/// The student that a child's name tells: "Ana García (12345)" for Moodle's "Ana García_12345_assignsubmission_file_",
/// else the name without an archive's or a source's suffix; printable.
std::string studentOf(const std::string& name);

}  // namespace muelle::grader
