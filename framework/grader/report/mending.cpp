#include "grader/report/mending.h"

#include "base/text/lists.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

class Mendings {
 public:
  explicit Mendings(const GradedExercise& exercise) {
    for (const Criterion& criterion : exercise.manifest.criteria) take(criterion, exercise);
    std::ranges::stable_sort(all_, std::ranges::greater{}, &Mending::points);
  }

  /// That which costs most first.
  std::vector<Mending> sorted() && { return std::move(all_); }

 private:
  void take(const Criterion& criterion, const GradedExercise& exercise) {
    const Explanation explanation = explain(criterion, exercise);
    if (explanation.state == Explanation::State::Passed || explanation.state == Explanation::State::GraderFault) return;
    const double lost = criterion.points - score(criterion, exercise).value_or(criterion.points);
    add(explanation.neverWritten, "", false, criterion, lost, {});
    for (const Explanation::Mistake& each : explanation.mistakes)
      add(each.says, each.hint, true, criterion, lost, explanation);
    if (explanation.mistakes.empty()) add(explanation.fault, "", false, criterion, lost, {});
  }

  void add(const std::string& says, const std::string& hint, bool isNamed, const Criterion& criterion, double lost,
           const Explanation& explanation) {
    if (says.empty()) return;
    auto known = std::ranges::find(all_, says, &Mending::says);
    if (known == all_.end()) known = all_.insert(all_.end(), {says, hint, "", isNamed, {}, 0.0});
    if (known->example.empty() && !explanation.examples.empty()) known->example = explanation.examples.front();
    known->criteria.push_back(criterion.name);
    known->points += lost;
  }

  std::vector<Mending> all_;
};

/// The criteria that do not pass, and nothing says why.
std::vector<std::string> withoutCause(const GradedExercise& exercise) {
  std::vector<std::string> names;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    const Explanation explanation = explain(criterion, exercise);
    const bool isLost =
        explanation.state == Explanation::State::Failed || explanation.state == Explanation::State::Partial;
    if (isLost && !explanation.hasCause()) names.push_back(criterion.name);
  }
  return names;
}

}  // namespace

std::vector<Mending> mendingsOf(const GradedExercise& exercise) { return Mendings(exercise).sorted(); }

std::vector<std::string> firstLines(const GradedExercise& exercise) {
  constexpr std::size_t most = 3;
  const std::vector<Criterion>& criteria = exercise.manifest.criteria;
  if (exercise.build.status != BuildOutcome::Status::Built) {
    return criteria.empty() ? std::vector<std::string>{} : std::vector{explain(criteria.front(), exercise).instead};
  }
  std::vector<std::string> lines;
  for (const Mending& each : mendingsOf(exercise)) lines.push_back(each.says);
  if (lines.size() > most) {
    lines.resize(most);
    lines.emplace_back("and more, see below");
  }
  const std::vector<std::string> names = withoutCause(exercise);
  if (!names.empty()) lines.push_back(fmt::format("not right yet: {}", joined(names, "; ")));
  return lines;
}

}  // namespace muelle::grader
