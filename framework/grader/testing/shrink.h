#pragma once
#include "course/contract.h"
#include "grader/testing/call_history.h"
#include "grader/verdict.h"

#include <optional>
#include <string>
#include <string_view>

namespace muelle::grader {

/// Looks for a wrong call of a function whose numbers one can check on paper: from the first wrong call on, numbers
/// become 0, 1, 2, or lose digits, and lists get shorter, within the contract's ranges, as long as the answer stays
/// wrong and every hypothesis that explained all calls explains the new one. The submission is asked anew for each.
///
/// \param contract the text of the header, for names and ranges
/// \return nullopt when no call was wrong. Throws SubmissionFault.
std::optional<CounterExample> simplestCounterExample(const std::string& function, CallHistoryBase& history,
                                                     std::string_view contract);

}  // namespace muelle::grader
