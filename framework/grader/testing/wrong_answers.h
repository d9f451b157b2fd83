#pragma once
#include "grader/testing/call_history.h"

namespace muelle::grader {

/// Some of a function's wrong answers, for authors who compare those of several hand-ins. Which ones follows from the
/// arguments of the calls alone, so that two hand-ins that were asked the same and err alike give the same sample.
std::vector<WrongAnswer> sampleOfWrongAnswers(const CallHistoryBase& history);

}  // namespace muelle::grader
