#pragma once
#include "grader/evidence.h"
#include "grader/testing/call_history.h"

#include <string>

namespace muelle::grader {

/// Whether a function keeps something of earlier calls although it repeats itself, as with `static double L = ...`,
/// which the first call of a process decides: asks a few of its wrong calls again, each as the first one of a process,
/// and compares bit by bit. A function whose answers a mistake explains is not asked.
///
/// \param found what the calls of `history` say; the history is left as it was
bool answersOtherwiseAfresh(const std::string& function, CallHistoryBase& history, const FunctionEvidence& found);

}  // namespace muelle::grader
