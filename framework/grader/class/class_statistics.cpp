#include "grader/class/class_statistics.h"

#include <algorithm>
#include <set>

namespace muelle::grader {

namespace {

std::optional<double> medianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const std::size_t upper = values.size() / 2;
  return values.size() % 2 == 1 ? values[upper] : 0.5 * values[upper - 1] + 0.5 * values[upper];
}

std::optional<double> medianTotal(const GradedClass& graded) {
  std::vector<double> totals;
  for (const ClassRow& row : graded.rows) {
    if (const std::optional<double> points = row.points()) totals.push_back(*points);
  }
  return medianOf(std::move(totals));
}

ExerciseStatistics statisticsOf(const Manifest& manifest, const GradedClass& graded) {
  ExerciseStatistics statistics;
  std::vector<double> all;
  for (const ClassRow& row : graded.rows) {
    const GradedExercise* exercise = row.exercise(manifest.topic);
    if (exercise == nullptr) continue;
    if (exercise->build.status != BuildOutcome::Status::Missing) ++statistics.handedIn;
    if (const std::optional<double> points = pointsOf(*exercise)) all.push_back(*points);
  }
  statistics.median = medianOf(std::move(all));
  return statistics;
}

CriterionStatistics statisticsOf(const Criterion& criterion, const Manifest& manifest, const GradedClass& graded) {
  CriterionStatistics statistics;
  statistics.topic = manifest.topic;
  statistics.name = criterion.name;
  for (const ClassRow& row : graded.rows) {
    const GradedExercise* exercise = row.exercise(manifest.topic);
    // A file that is missing or does not compile says nothing about this criterion.
    if (exercise == nullptr || exercise->build.status != BuildOutcome::Status::Built) continue;
    const std::optional<double> points = score(criterion, *exercise);
    if (!points) continue;
    ++statistics.judged;
    if (*points >= criterion.points) ++statistics.passed;
  }
  return statistics;
}

std::vector<CriterionStatistics> hardestFirst(const GradedClass& graded) {
  std::vector<CriterionStatistics> criteria;
  for (const Manifest& manifest : graded.course) {
    for (const Criterion& criterion : manifest.criteria) {
      CriterionStatistics statistics = statisticsOf(criterion, manifest, graded);
      if (statistics.passed < statistics.judged) criteria.push_back(std::move(statistics));
    }
  }
  // Equal ones stay in the order of the course.
  std::ranges::stable_sort(criteria, {}, &CriterionStatistics::share);
  return criteria;
}

std::set<std::string> mistakesOf(const GradedExercise& exercise) {
  std::set<std::string> ids;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    for (std::string& id : mistakesOf(criterion, exercise)) ids.insert(std::move(id));
  }
  return ids;
}

/// As the manifest says it, or, of a mistake that any function may hold, as the first student was told.
std::string wordsOf(const std::string& id, const GradedExercise& exercise) {
  const std::vector<Misconception>& stated = exercise.manifest.misconceptions;
  if (const auto known = std::ranges::find(stated, id, &Misconception::id); known != stated.end()) return known->says;
  for (const auto& [suite, verdict] : exercise.verdicts) {
    const auto named = std::ranges::find(verdict.mistakes, id, &NamedMistake::id);
    if (named != verdict.mistakes.end()) return named->says;
  }
  return "";
}

void count(const std::string& id, const GradedExercise& exercise, std::vector<MistakeStatistics>& mistakes) {
  const Manifest& manifest = exercise.manifest;
  const auto known = std::ranges::find_if(
      mistakes, [&](const MistakeStatistics& mistake) { return mistake.id == id && mistake.topic == manifest.topic; });
  if (known != mistakes.end()) {
    ++known->students;
  } else {
    mistakes.push_back({manifest.topic, id, wordsOf(id, exercise), 1});
  }
}

std::vector<MistakeStatistics> commonestFirst(const GradedClass& graded) {
  std::vector<MistakeStatistics> mistakes;
  for (const Manifest& manifest : graded.course) {
    for (const ClassRow& row : graded.rows) {
      const GradedExercise* exercise = row.exercise(manifest.topic);
      if (exercise == nullptr) continue;
      for (const std::string& id : mistakesOf(*exercise)) count(id, *exercise, mistakes);
    }
  }
  std::ranges::stable_sort(mistakes, std::ranges::greater{}, &MistakeStatistics::students);
  return mistakes;
}

}  // namespace

ClassStatistics statisticsOf(const GradedClass& graded) {
  ClassStatistics statistics;
  statistics.median = medianTotal(graded);
  for (const Manifest& manifest : graded.course) statistics.exercises.push_back(statisticsOf(manifest, graded));
  statistics.criteria = hardestFirst(graded);
  statistics.mistakes = commonestFirst(graded);
  return statistics;
}

std::vector<std::string> mistakesOf(const Criterion& criterion, const GradedExercise& exercise) {
  const std::optional<double> points = score(criterion, exercise);
  const auto verdict = exercise.verdicts.find(criterion.suite);
  if (!points || *points >= criterion.points || verdict == exercise.verdicts.end()) return {};
  std::vector<std::string> ids;
  for (const NamedMistake& mistake : verdict->second.mistakes) {
    if (std::ranges::find(ids, mistake.id) == ids.end()) ids.push_back(mistake.id);
  }
  return ids;
}

}  // namespace muelle::grader
