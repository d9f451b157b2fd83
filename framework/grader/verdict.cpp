#include "grader/verdict.h"

#include "grader/report/explanation.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

/// A record counts only for the criterion that it names.
bool belongs(const Verdict& verdict, const Criterion& criterion, const GradedExercise& exercise) {
  return verdict.suite == criterion.suite && verdict.topic == exercise.manifest.topic;
}

/// The record of the criterion; null when there is none that counts.
const Verdict* recordOf(const Criterion& criterion, const GradedExercise& exercise) {
  const auto found = exercise.verdicts.find(criterion.suite);
  const bool counts = found != exercise.verdicts.end() && belongs(found->second, criterion, exercise);
  return counts ? &found->second : nullptr;
}

bool everyTestPassed(const Verdict& verdict) {
  return std::ranges::all_of(verdict.tests, [](const TestOutcome& test) { return test.passed; });
}

/// A function that was wrong, or ended its calls by its own fault, leaves the points of the tests that do without it.
/// What passes by luck, misuses memory or asks for what is forbidden leaves nothing.
bool leavesOtherTests(const Verdict& verdict) {
  const Outcome outcome = verdict.outcome;
  if (verdict.fault.empty()) return outcome == Outcome::Wrong || outcome == Outcome::NeverWritten;
  const bool isOfOne =
      outcome == Outcome::Wrong || outcome == Outcome::Crash || outcome == Outcome::Cpu || outcome == Outcome::Link;
  return isOfOne && !verdict.isConfirmed;
}

double earned(const Criterion& criterion, const Verdict& verdict) {
  if (verdict.passed()) return criterion.points;
  if (!criterion.partial || !leavesOtherTests(verdict) || everyTestPassed(verdict)) return 0.0;
  const auto passed = std::ranges::count_if(verdict.tests, [](const TestOutcome& test) { return test.passed; });
  return criterion.points * static_cast<double>(passed) / static_cast<double>(verdict.tests.size());
}

/// The outcome and the tests of a record are two witnesses of the same.
bool contradictsItself(const Verdict& verdict) {
  if (!verdict.fault.empty()) return false;
  return (verdict.outcome == Outcome::Passed && !everyTestPassed(verdict)) ||
         (verdict.outcome == Outcome::Wrong && everyTestPassed(verdict));
}

constexpr const char* again = "the grader failed, not you; run the same command again";

std::string faultOf(const Verdict* record) {
  if (record == nullptr) return fmt::format("no record of this criterion: {}", again);
  const auto because = [](const std::string& reason) {
    return "the grader failed, not you; no score, it will be run again: " + reason;
  };
  if (!record->graderFault.empty()) return because(record->graderFault);
  if (record->outcome == Outcome::Killed)
    return because(record->fault.empty() ? "the run was killed from outside" : record->fault);
  if (record->outcome == Outcome::Wall)
    return because(record->fault.empty() ? "the machine was too busy to finish the run" : record->fault);
  // Nothing was tested and nobody is blamed for it: no evidence of anything.
  if (record->tests.empty() && record->fault.empty())
    return fmt::format("the record of this criterion holds no test: {}", again);
  if (contradictsItself(*record)) return fmt::format("the record of this criterion contradicts itself: {}", again);
  return "";
}

}  // namespace

std::string graderFault(const Criterion& criterion, const GradedExercise& exercise) {
  using Status = BuildOutcome::Status;
  if (exercise.build.status == Status::GraderFault) {
    const std::string& message = exercise.build.message;
    return "the grader failed, not you; no score, it will be run again: " +
           (message.empty() ? "the build did not run" : message);
  }
  return exercise.build.status == Status::Built ? faultOf(recordOf(criterion, exercise)) : "";
}

std::optional<double> score(const Criterion& criterion, const GradedExercise& exercise) {
  if (!graderFault(criterion, exercise).empty()) return std::nullopt;
  if (exercise.build.status != BuildOutcome::Status::Built) return 0.0;
  return earned(criterion, *recordOf(criterion, exercise));
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

bool hasGraderFault(const GradedExercise& exercise) {
  return exercise.build.status == BuildOutcome::Status::GraderFault ||
         std::ranges::any_of(exercise.manifest.criteria,
                             [&](const Criterion& criterion) { return !graderFault(criterion, exercise).empty(); });
}

bool hasGraderFault(const GradedSubmission& submission) {
  return std::ranges::any_of(submission.exercises,
                             [](const GradedExercise& exercise) { return hasGraderFault(exercise); });
}

std::vector<std::string> feedback(const Criterion& criterion, const GradedExercise& exercise) {
  const Explanation explanation = explain(criterion, exercise);
  std::vector<std::string> lines;
  const auto say = [&](const std::string& text) {
    if (!text.empty()) lines.push_back(text);
  };
  say(explanation.instead);
  say(explanation.neverWritten);
  for (const auto& mistake : explanation.mistakes) {
    say(mistake.says);
    say(mistake.hint);
  }
  say(explanation.fault);
  for (const std::string& example : explanation.examples) say("for example " + example);
  for (const auto& test : explanation.tests) say("not yet: " + test.property);
  for (const auto& test : explanation.tests) {
    for (const auto& failure : test.failures) {
      say(failure.call);
      if (!failure.sentence.empty()) say("  " + failure.sentence);
    }
    if (!test.more.empty()) say("  " + test.more);
  }
  if (!explanation.hint.empty()) say("hint: " + explanation.hint);
  if (lines.empty() && explanation.state != Explanation::State::Passed) say("failed");
  if (!explanation.note.empty()) say("note: " + explanation.note);
  return lines;
}

}  // namespace muelle::grader
