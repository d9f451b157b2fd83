#pragma once
#include "grader/verdict.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// What a student reads about functions that are right in spite of a lower one, once for each lower function that has
/// lost points: "one mistake, in springForceOnA, costs these 3 points; what you built on it is right."
std::vector<std::string> followedSentences(const GradedExercise& exercise);

}  // namespace muelle::grader
