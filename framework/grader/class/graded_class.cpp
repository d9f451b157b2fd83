#include "grader/class/graded_class.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

std::optional<double> ClassRow::points() const {
  if (trouble || hasGraderFault(graded)) return std::nullopt;
  return score(graded);
}

const GradedExercise* ClassRow::exercise(const std::string& topic) const {
  if (trouble) return nullptr;
  const auto found = std::ranges::find_if(
      graded.exercises, [&topic](const GradedExercise& exercise) { return exercise.manifest.topic == topic; });
  return found == graded.exercises.end() ? nullptr : &*found;
}

std::string ClassRow::whyNoPoints() const {
  if (trouble) return printableLine(*trouble);
  for (const GradedExercise& exercise : graded.exercises) {
    for (const Criterion& criterion : exercise.manifest.criteria) {
      if (score(criterion, exercise)) continue;
      return fmt::format("{}: {}", exercise.manifest.topic, feedback(criterion, exercise).front());
    }
  }
  return "";
}

int GradedClass::faults() const {
  return static_cast<int>(std::ranges::count_if(rows, [](const ClassRow& row) { return !row.points(); }));
}

std::vector<std::string> GradedClass::missingReports() const {
  std::vector<std::string> lines;
  for (const ClassRow& row : rows) {
    if (!row.reportFault.empty()) lines.push_back(fmt::format("{}: {}", row.student, printableLine(row.reportFault)));
  }
  return lines;
}

double GradedClass::maxPoints() const {
  double sum = 0.0;
  for (const Manifest& exercise : course) sum += grader::maxPoints(exercise);
  return sum;
}

double maxPoints(const Manifest& exercise) {
  double sum = 0.0;
  for (const Criterion& criterion : exercise.criteria) sum += criterion.points;
  return sum;
}

std::optional<double> pointsOf(const GradedExercise& exercise) {
  double sum = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    const std::optional<double> points = score(criterion, exercise);
    if (!points) return std::nullopt;
    sum += *points;
  }
  return sum;
}

}  // namespace muelle::grader
