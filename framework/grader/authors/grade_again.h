#pragma once
#include "grader/authors/unnamed_groups.h"
#include "grader/run/keys.h"

namespace muelle::grader {

/// A hand-in of one exercise that has lost points without a name.
struct UnnamedHandIn {
  std::string name;
  Manifest manifest;
  Sources sources;
};

/// Asks all of them the same questions, as students are not asked, and groups those whose wrong answers are the same.
/// \param options those of the grading before; what was compiled then is not compiled again
std::vector<UnnamedGroup> gradeAgain(const Workplace& workplace, const GradeOptions& options,
                                     const std::vector<UnnamedHandIn>& handIns, int jobs);

}  // namespace muelle::grader
