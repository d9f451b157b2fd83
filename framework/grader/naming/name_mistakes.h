#pragma once
#include "grader/verdict.h"

#include <string>
#include <string_view>

namespace muelle::grader {

/// A name is said only when it explains at least so many wrong answers.
constexpr long fewestWrong = 3;

/// Names the mistake of each function, where one explains all its answers in all criteria, and writes it into the
/// verdicts of the criteria that were lost by that function (Verdict::mistakes).
///
/// A mistake that the manifest lists goes before one that any function may have; where two of them explain everything,
/// both are said. What the manifest says of a lower function is said of another one only where the lower one was wrong
/// as well. What a test has seen at work (seen.h) is said besides, in its own criterion.
/// \param contract the text of the exercise's header   \param source the student's
void nameMistakes(GradedExercise& exercise, std::string_view contract, std::string_view source);

}  // namespace muelle::grader
