#pragma once
#include <string>
#include <vector>

namespace muelle {

/// Number of single-character edits (insert, delete, replace, swap of neighbours) that turn one word into the other.
int editDistance(const std::string& a, const std::string& b);

/// The name closest to `word`, or "" when none is close enough to be what was meant (a third of its length, at least
/// 1).
std::string nearest(const std::string& word, const std::vector<std::string>& names);

/// "; did you mean 'points'?" or "" when nothing is near.
std::string didYouMean(const std::string& word, const std::vector<std::string>& names);

/// What to say after an unknown word: "; did you mean 'points'?", or "; there are order, points, title" when nothing is
/// near.
std::string suggestion(const std::string& word, const std::vector<std::string>& names);

}  // namespace muelle
