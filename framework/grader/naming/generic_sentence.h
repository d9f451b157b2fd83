#pragma once
#include "course/contract.h"
#include "grader/evidence.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// A number among the arguments in the student's words: "k", "top.L0", "z of xa", "k of springs".
std::string wordsOf(const Leaf& leaf, const std::vector<Parameter>& parameters);

/// What a mistake that any function may hold does, as an effect, which is true whatever its cause:
/// "springForce gives the right numbers with the wrong sign". "" for an id of which nothing is known.
std::string sentenceOf(const Hypothesis& hypothesis, const std::string& function,
                       const std::vector<Parameter>& parameters);

/// Where right and wrong answers part: "L between right and wrong": "right where the distance of xa and xb is 1e-6 or
/// more, wrong where it is 3e-7 or less". "" when no feature separates them surely.
struct Separation {
  std::string id;     ///< "threshold" of short lengths, "one_sided" of a sign, "edge" of the number 0
  std::string where;  ///< "the distance of xa and xb is 3e-07 or less"
};

/// The first feature that tells all right calls from all wrong ones, of which there must be so many that no accident
/// does; an empty id when there is none.
Separation separationOf(const FunctionEvidence& evidence, const std::vector<Parameter>& parameters);

}  // namespace muelle::grader
