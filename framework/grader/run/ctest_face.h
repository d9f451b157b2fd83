#pragma once
#include "grader/run/workplace.h"

#include <string>

namespace muelle::grader {

/// Exit statuses of the steps that CTest runs.
inline constexpr int stepPassed = 0;
inline constexpr int stepFailed = 1;
inline constexpr int graderAtFault = 2;

/// Writes the file that CTest includes: for each exercise a fixture that grades it, a test for each criterion and one
/// for the curves; labels `grade` and the topic.
int writeCtestFile(const Workplace& workplace, const std::string& file);

/// Grades one exercise of the submission that the environment names (MUELLE_SUBMISSION, MUELLE_SEED, MUELLE_SANDBOX)
/// and leaves what is said of each criterion for readForCtest() of the same run of CTest.
int gradeForCtest(const Workplace& workplace, const std::string& topic);

/// Prints what was said of a criterion (or of "curves") and returns its status; graderAtFault when nothing was said.
int readForCtest(const Workplace& workplace, const std::string& topic, const std::string& suite);

}  // namespace muelle::grader
