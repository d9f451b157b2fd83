#pragma once
#include "grader/evidence.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// The ends of the contract's ranges (MUELLE_RANGE) that the hidden tests do not pass, through each function that has
/// an argument, or a struct's field, or a list, of that name: one line each. Empty when all are passed. \param evidence
/// of all criteria, asked of any submission that answers every call
std::vector<std::string> endsNotPassed(std::string_view contract, const Evidence& evidence);

}  // namespace muelle::grader
