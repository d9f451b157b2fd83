#pragma once
#include "grader/authoring/withheld.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace muelle::grader {

/// The files of a student's tree: path -> text.
using Tree = std::map<std::string, std::string>;

/// Stands in every line of a scaffold that its author has to write: "WRITE: what".
inline constexpr const char* writeMark = "WRITE:";

/// Something in a student's tree that is not for students.
struct Leak {
  std::string file;
  int line = 0;
  std::string what;  ///< "answers an exercise: ..."

  std::string text() const;
};

/// Looks for answers (expressions of solutions and right submissions, in whatever names; functions that students write,
/// outside of their stubs), for sentences, numbers and names that only solutions, hidden tests and the instructors'
/// rooms have, for files of those, and for paths of this machine. \param paths of this machine, none of which may stand
/// in a file
std::vector<Leak> findLeaks(const Tree& tree, const Withheld& withheld, const std::vector<std::string>& paths);

}  // namespace muelle::grader
