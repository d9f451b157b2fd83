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
/// The same of a sum: no score as soon as one part has none.
std::string showScore(const GradedExercise& exercise);
std::string showScore(const GradedSubmission& graded);

/// "passed", "in part", "failed", "not run", "grader's fault".
std::string showState(Explanation::State state);

/// The sign that stands for it: "✓" "~" "✗" "–" "!".
const char* showMark(Explanation::State state);

/// What a student reads above everything where the grader is at fault.
inline constexpr const char* faultSentence =
    "The grader failed on part of this submission. That is not your fault: there is no score yet, and it will be run "
    "again.";

/// Sum of the criteria's points.
double maxScore(const GradedExercise& exercise);

/// "Seed of the inputs of Springs in space: 123": by it they can be drawn again; "" when none were asked.
std::string seedSentence(const GradedExercise& exercise);

/// "bubblewrap", or a warning when the name is missing: one printable line.
std::string showSandbox(const std::string& sandbox);
std::string showSandbox(const GradedSubmission& graded);

/// The most that a field of a file for other programs takes, in bytes.
constexpr std::size_t fieldBytes = 8 * 1024;

/// A text, printable or not, as such a field: printable, several lines, at most `fieldBytes` long.
std::string field(const std::string& text);
/// The same on one line.
std::string fieldLine(const std::string& text);

/// feedback() as one text, a line each.
std::string feedbackText(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader
