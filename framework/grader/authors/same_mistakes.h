#pragma once
#include "grader/verdict.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// What is wrong with the mistakes that an exercise lists, one line each: two of a function that give the same numbers
/// in every call of all criteria, so that neither can be named alone, and one that is right in all of them. Over all
/// criteria, as names are given: calls of one criterion may tell apart what another's do not.
/// \param verdicts of a submission that passes, graded for authors (GradeOptions::forAuthors)
std::vector<std::string> mistakesNotToldApart(const std::map<std::string, Verdict>& verdicts);

}  // namespace muelle::grader
