#include "base/text/nearest.h"

#include "base/text/lists.h"

#include <algorithm>

namespace muelle {

int editDistance(const std::string& a, const std::string& b) {
  const std::size_t rows = a.size() + 1;
  const std::size_t cols = b.size() + 1;
  std::vector<int> distance(rows * cols);
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return distance[i * cols + j]; };
  for (std::size_t i = 0; i < rows; ++i) at(i, 0) = static_cast<int>(i);
  for (std::size_t j = 0; j < cols; ++j) at(0, j) = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i) {
    for (std::size_t j = 1; j < cols; ++j) {
      const int replaced = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return at(rows - 1, cols - 1);
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
  const int limit = std::max(1, static_cast<int>(word.size()) / 3);
  std::string best;
  int bestDistance = limit + 1;
  for (const std::string& name : names) {
    const int distance = editDistance(word, name);
    // A beginning of the name is what was meant too, however much is missing: "spring" for "spring_1d".
    const bool isBeginning = word.size() >= 3 && name.starts_with(word);
    const int cost = isBeginning ? std::min(distance, limit) : distance;
    if (cost < bestDistance) {
      best = name;
      bestDistance = cost;
    }
  }
  return best;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& names) {
  const std::string name = nearest(word, names);
  return name.empty() ? "" : "; did you mean '" + name + "'?";
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
  const std::string guess = didYouMean(word, names);
  if (!guess.empty()) return guess;
  return (names.size() == 1 ? "; there is " : "; there are ") + (names.empty() ? "none" : joined(names, ", "));
}

}  // namespace muelle
