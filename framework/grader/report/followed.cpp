#include "grader/report/followed.h"

#include "base/text/printable.h"
#include "grader/report/format.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::grader {

namespace {

/// The lower functions by which a criterion of the exercise was earned, each once, in the order of the criteria.
std::vector<std::string> followedIn(const GradedExercise& exercise) {
  std::vector<std::string> functions;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    const auto verdict = exercise.verdicts.find(criterion.suite);
    if (verdict == exercise.verdicts.end()) continue;
    for (const std::string& function : verdict->second.followed) {
      if (std::ranges::find(functions, function) == functions.end()) functions.push_back(function);
    }
  }
  return functions;
}

/// Points that the criteria that judge the function have not given. What several functions share is lost by the first.
/// \param told the criteria of which it has been said who has lost them
double lostBy(const std::string& function, const GradedExercise& exercise, std::set<std::string>& told) {
  double lost = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    if (std::ranges::find(criterion.functions, function) == criterion.functions.end()) continue;
    if (told.insert(criterion.suite).second) {
      lost += criterion.points - score(criterion, exercise).value_or(criterion.points);
    }
  }
  return lost;
}

}  // namespace

std::vector<std::string> followedSentences(const GradedExercise& exercise) {
  std::vector<std::string> sentences;
  std::set<std::string> told;
  for (const std::string& function : followedIn(exercise)) {
    const double lost = lostBy(function, exercise, told);
    if (lost <= 0.0) continue;
    const std::string points = lost == 1.0 ? "this point" : fmt::format("these {} points", showPoints(lost));
    sentences.push_back(
        fmt::format("one mistake, in {}, costs {}; what you built on it is right.", printableLine(function), points));
  }
  return sentences;
}

}  // namespace muelle::grader
