#pragma once
#include "grader/authoring/lint.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// What a contract does not say: a function without a docstring, a number or a list without range, a number or vector
/// without unit. A unit is one in brackets, "[N/m]", on a line that names the argument or stands above the function, or
/// the comment behind its MUELLE_RANGE; words such as "unit vector" or "number of" say that there is none.
/// \param shown the file's name in messages
std::vector<Finding> lintContract(std::string_view contract, const std::string& shown);

}  // namespace muelle::grader
