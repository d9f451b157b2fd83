#pragma once
/// \file
/// Numbers and lines that every report shows the same way.

#include "grader/report/explanation.h"
#include "grader/verdict.h"

#include <string>

namespace muelle::grader {

/// Points with at most two decimals: "2", "1.5", "0.67".
std::string showPoints(double points);

/// Points of a criterion, or "no score" when the grader is at fault.
std::string showScore(const Criterion& criterion, const GradedExercise& exercise);

/// "passed", "in part", "failed", "not run", "grader's fault".
std::string showState(Explanation::State state);

/// Sum of the criteria's points.
double maxScore(const GradedExercise& exercise);

/// "bubblewrap", or a warning when the name is missing: one printable line.
std::string showSandbox(const GradedSubmission& graded);

/// feedback() as one text, a line each.
std::string feedbackText(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader
