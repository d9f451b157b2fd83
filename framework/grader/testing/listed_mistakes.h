#pragma once
#include "grader/testing/call_history.h"

namespace muelle::grader {

/// The mistakes that an exercise lists for a function, by what they give in all calls of the history: those that agree
/// in every call are of one group, those that agree with the oracle of group 0.
std::vector<ListedMistake> listedMistakes(const CallHistoryBase& history);

}  // namespace muelle::grader
