#include "grader/report/mending.h"

#include <algorithm>

namespace muelle::grader {

namespace {

class Mendings {
 public:
  explicit Mendings(const GradedExercise& exercise) {
    for (const Criterion& criterion : exercise.manifest.criteria) take(criterion, exercise);
    std::ranges::stable_sort(all_, std::ranges::greater{}, &Mending::points);
  }

  std::vector<Mending> take() { return std::move(all_); }

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

}  // namespace

std::vector<Mending> mendingsOf(const GradedExercise& exercise) { return Mendings(exercise).take(); }

}  // namespace muelle::grader
