#pragma once
#include "grader/verdict.h"

#include "support/hostile_texts.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// An exercise "spring_1d" with two criteria: HookeForce (4 points, all or nothing) and Acceleration (3 points,
/// partial), and the misconception wrong_sign. Built, without verdicts.
GradedExercise exerciseWithoutVerdicts();

/// A verdict of that exercise with as many passed and failed tests; failed ones have a property, a call and a detail.
Verdict verdict(const std::string& suite, int passed, int failed);

/// Puts the verdict into the exercise, under its suite.
GradedExercise with(GradedExercise exercise, const Verdict& verdict);

/// One submission with an exercise in every state: passed, partial, failed with a misconception, a crash, missing,
/// not compiling.
/// As the pool names a force of the wrong sign.
NamedMistake namedSign();

GradedSubmission sampleSubmission();

/// A submission with the text in every place that a submission can reach.
GradedSubmission hostileSubmission(const std::string& text);

}  // namespace muelle::grader
