#pragma once
#include "grader/authors/unnamed_groups.h"

#include <string>
#include <string_view>

namespace muelle::grader {

/// What an author pastes to have the mistake of a group named: MUELLE_MISTAKE for mistakes.cpp, which begins with the
/// first hand-in's own function, or with the oracle's call where that cannot be cut out, and the entry for
/// exercise.toml. Printable. \param contract the text of the exercise's header
std::string mistakeText(const UnnamedGroup& group, std::string_view contract);

/// Who is in the group, its simplest call, and mistakeText().
std::string groupText(const UnnamedGroup& group, std::string_view contract);

}  // namespace muelle::grader
