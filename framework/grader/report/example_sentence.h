#pragma once
#include "grader/verdict.h"

#include <string>

namespace muelle::grader {

/// "springForce(Vec3(0, 0, 0), Vec3(2, 0, 0), 1, 1): you return (-1, 0, 0), it is (1, 0, 0)". Not made printable.
std::string exampleSentence(const CounterExample& example);

/// Whether every number of its call has at most two digits that count: 0.25 and 3000, not 1.37.
bool isForPaper(const CounterExample& example);

}  // namespace muelle::grader
