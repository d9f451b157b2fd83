#pragma once
#include "grader/matrix/matrix.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::grader {

/// Something that an exercise lacks.
struct Finding {
  std::string where;  ///< file and line, or the folder
  std::string what;   ///< is missing or wrong
  std::string todo;   ///< what to do

  /// One line.
  std::string text() const;
};

/// The manifests of the course that cannot be read, and two that contradict each other: what stops every build of the
/// graded tests, each in one line, read off the files alone.
std::vector<Finding> lintManifests(const std::filesystem::path& checkout);

/// What can be read off the files of an exercise: a missing file, a line still to be written, a manifest that is none,
/// an empty hint, too few criteria, a statement without figure, a contract without units or ranges, too few
/// submissions, a criterion that no wrong submission loses, a mistake that none shows, a submission that is not known
/// to come out as stated. \param checkout the folder that has exercises/ and the others
std::vector<Finding> lintFiles(const std::filesystem::path& checkout, const std::string& topic);

/// What the public tests say: a stub that passes, a solution that fails. Their programs must be built.
std::vector<Finding> lintPublicTests(const Workplace& workplace, const Manifest& manifest);

/// What the hidden tests say, of the rows that were graded: a stub with points, a solution or another right submission
/// that loses, a wrong one that is not caught as stated, an end of a range that is not passed, mistakes not told apart.
std::vector<Finding> lintGraded(const TopicMatrix& matrix);

}  // namespace muelle::grader
