#pragma once
#include "grader/evidence.h"
#include "grader/testing/call_history.h"

namespace muelle::grader {

/// What the calls of one function say; no calls without an oracle. A hypothesis agrees when it gives the submission's
/// numbers in all calls, right and wrong ones.
FunctionEvidence gatherEvidence(const CallHistoryBase& history);

}  // namespace muelle::grader
