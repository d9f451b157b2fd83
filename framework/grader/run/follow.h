#pragma once
#include "grader/run/judge.h"

namespace muelle::grader {

/// Judges a criterion that has failed once more, without the mistakes of the lower functions that it follows: by values
/// computed from the student's own, then with the reference's in their place. Both only where each of them is of use,
/// or shows one named mistake. \param failed what the criterion came to as it is \return the record of the run that
/// earned it, with `followed`; else `failed`, or a fault of ours when it could not be found out
Verdict followLower(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
                    const GradeOptions& options, const Verdict& failed);

}  // namespace muelle::grader
