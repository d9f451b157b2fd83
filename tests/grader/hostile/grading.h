#pragma once
#include "grader/run/grade.h"

#include <filesystem>
#include <string>

namespace muelle::grader {

/// Grades one exercise of a hand-in as `muelle grade` does, nothing kept from earlier runs and nothing kept after, with
/// the sandbox of MUELLE_SANDBOX or the strongest that works.
/// \param judgesSymbols false: what the file uses is not looked at before it runs, so that the sandbox stands alone
GradedSubmission gradeAttack(const std::filesystem::path& submission, const std::string& topic,
                             bool judgesSymbols = true);

/// Asserts what is asked of every attack: no point, no fault of the grader, words for the student that match `says`
/// ("" for any), and reports in which nothing of the attack comes alive.
void expectDefeated(const GradedSubmission& graded, const std::string& says);

}  // namespace muelle::grader
