#include "grader/verdict.h"

#include "grader/report/explanation.h"

#include <algorithm>

namespace muelle::grader {

namespace {

/// A record counts only for the criterion that it names.
bool belongs(const Verdict& verdict, const Criterion& criterion, const GradedExercise& exercise) {
  return verdict.suite == criterion.suite && verdict.topic == exercise.manifest.topic;
}

double earned(const Criterion& criterion, const Verdict& verdict) {
  if (verdict.passed()) return criterion.points;
  if (!criterion.partial || !verdict.fault.empty() || verdict.tests.empty()) return 0.0;
  const auto passed = std::count_if(verdict.tests.begin(), verdict.tests.end(), [](const auto& t) { return t.passed; });
  return criterion.points * static_cast<double>(passed) / static_cast<double>(verdict.tests.size());
}

}  // namespace

std::optional<double> score(const Criterion& criterion, const GradedExercise& exercise) {
  if (exercise.build.status == BuildOutcome::Status::GraderFault) return std::nullopt;
  if (exercise.build.status != BuildOutcome::Status::Built) return 0.0;
  const auto found = exercise.verdicts.find(criterion.suite);
  if (found == exercise.verdicts.end() || !belongs(found->second, criterion, exercise)) return 0.0;
  if (!found->second.graderFault.empty()) return std::nullopt;
  return earned(criterion, found->second);
}

double score(const GradedExercise& exercise) {
  double sum = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) sum += score(criterion, exercise).value_or(0.0);
  return sum;
}

double score(const GradedSubmission& submission) {
  double sum = 0.0;
  for (const GradedExercise& exercise : submission.exercises) sum += score(exercise);
  return sum;
}

double maxScore(const GradedSubmission& submission) {
  double sum = 0.0;
  for (const GradedExercise& exercise : submission.exercises) {
    for (const Criterion& criterion : exercise.manifest.criteria) sum += criterion.points;
  }
  return sum;
}

bool hasGraderFault(const GradedSubmission& submission) {
  return std::any_of(submission.exercises.begin(), submission.exercises.end(), [](const GradedExercise& exercise) {
    const auto& criteria = exercise.manifest.criteria;
    return exercise.build.status == BuildOutcome::Status::GraderFault ||
           std::any_of(criteria.begin(), criteria.end(), [&](const Criterion& c) { return !score(c, exercise); });
  });
}

std::vector<std::string> feedback(const Criterion& criterion, const GradedExercise& exercise) {
  const Explanation explanation = explain(criterion, exercise);
  std::vector<std::string> lines;
  const auto say = [&](const std::string& text) {
    if (!text.empty()) lines.push_back(text);
  };
  say(explanation.instead);
  for (const auto& mistake : explanation.mistakes) {
    say(mistake.says);
    say(mistake.hint);
  }
  say(explanation.fault);
  for (const auto& test : explanation.tests) say("not yet: " + test.property);
  for (const auto& test : explanation.tests) {
    say(test.call);
    for (const std::string& detail : test.details) say("  " + detail);
  }
  if (!explanation.hint.empty()) say("hint: " + explanation.hint);
  if (lines.empty() && explanation.state != Explanation::State::Passed) say("failed");
  return lines;
}

}  // namespace muelle::grader
