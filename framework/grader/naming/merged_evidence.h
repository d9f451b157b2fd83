#pragma once
#include "grader/verdict.h"

namespace muelle::grader {

/// What all criteria say of each function: calls are counted together, and a mistake explains the function only when it
/// agrees in every criterion that called it. A criterion that was earned by following has asked another's functions.
Evidence mergedEvidence(const std::map<std::string, Verdict>& verdicts);

}  // namespace muelle::grader
