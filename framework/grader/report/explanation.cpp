#include "grader/report/explanation.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>

namespace muelle::grader {

namespace {

using State = Explanation::State;

constexpr std::size_t shownDetails = 4;
constexpr std::size_t shownBytes = 2000;
constexpr std::size_t outputBytes = 8 * 1024;

std::string line(const std::string& text) { return cut(printableLine(text), shownBytes); }

/// The tests write submission::springForce(...); in a student's file the function has no such prefix.
std::string asStudentsWrite(std::string text) {
  constexpr std::string_view prefix = "submission::";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
    text.erase(at, prefix.size());
  return line(text);
}

const Verdict* verdictOf(const Criterion& criterion, const GradedExercise& exercise) {
  const auto found = exercise.verdicts.find(criterion.suite);
  return found == exercise.verdicts.end() ? nullptr : &found->second;
}

std::string unbuilt(const GradedExercise& exercise) {
  const std::string file = exercise.manifest.files.empty() ? exercise.manifest.topic : exercise.manifest.files.front();
  const auto say = [&](const std::string& otherwise) {
    return exercise.build.message.empty() ? otherwise : line(exercise.build.message);
  };
  switch (exercise.build.status) {
    case BuildOutcome::Status::Built:
      return "";
    case BuildOutcome::Status::Missing:
      return say(fmt::format("{} was not handed in", file));
    case BuildOutcome::Status::Refused:
      return say(fmt::format("{} was refused", file));
    case BuildOutcome::Status::CompileError:
      return say(fmt::format("{} does not compile", file));
    case BuildOutcome::Status::GraderFault:
      break;
  }
  return "the grader failed, not you; no score, it will be run again: " + say("the build did not run");
}

/// The criterion's state when the exercise was built and a record is there.
State stateOf(const Criterion& criterion, const GradedExercise& exercise) {
  const std::optional<double> points = score(criterion, exercise);
  if (!points) return State::GraderFault;
  if (*points >= criterion.points && verdictOf(criterion, exercise)->passed()) return State::Passed;
  return *points > 0.0 ? State::Partial : State::Failed;
}

/// One mistake may show in several functions; the manifest may say something else for each, or the same for all.
bool isStatedFor(const NamedMistake& named, const Manifest& manifest) {
  return std::ranges::any_of(manifest.misconceptions, [&named](const Misconception& known) {
    return known.id == named.id && known.function == named.function;
  });
}

std::vector<Explanation::Mistake> mistakesOf(const Verdict& verdict, const Manifest& manifest) {
  std::vector<Explanation::Mistake> mistakes;
  // In the manifest's order: a function that another one is made of stands first.
  for (const Misconception& known : manifest.misconceptions) {
    const bool isNamed = std::ranges::any_of(verdict.misconceptions, [&](const NamedMistake& named) {
      return named.id == known.id && (named.function == known.function || !isStatedFor(named, manifest));
    });
    if (isNamed) mistakes.push_back({line(known.says), line(known.hint)});
  }
  return mistakes;
}

std::vector<std::string> detailsOf(const TestOutcome& test) {
  std::vector<std::string> details;
  for (std::size_t i = 0; i < std::min(test.details.size(), shownDetails); ++i)
    details.push_back(asStudentsWrite(test.details[i]));
  if (test.details.size() > shownDetails)
    details.push_back(fmt::format("... and {} more", test.details.size() - shownDetails));
  return details;
}

std::vector<Explanation::FailedTest> failedTests(const Verdict& verdict, FeedbackLevel level) {
  std::vector<Explanation::FailedTest> failed;
  if (level == FeedbackLevel::Criterion) return failed;
  for (const TestOutcome& test : verdict.tests) {
    if (test.passed) continue;
    Explanation::FailedTest shown{line(test.name), line(test.property.empty() ? test.name : test.property), "", {}};
    if (level == FeedbackLevel::Values) {
      shown.call = asStudentsWrite(test.call);
      shown.details = detailsOf(test);
    }
    failed.push_back(std::move(shown));
  }
  return failed;
}

}  // namespace

Explanation explain(const Criterion& criterion, const GradedExercise& exercise) {
  Explanation explanation;
  explanation.instead = unbuilt(exercise);
  if (!explanation.instead.empty()) {
    const bool ours = exercise.build.status == BuildOutcome::Status::GraderFault;
    explanation.state = ours ? State::GraderFault : State::NotRun;
    return explanation;
  }
  const Verdict* verdict = verdictOf(criterion, exercise);
  if (verdict == nullptr) {
    explanation.instead = "not run: there is no record of this criterion";
    return explanation;
  }
  explanation.state = stateOf(criterion, exercise);
  if (explanation.state == State::GraderFault) {
    explanation.instead = "the grader failed, not you; no score, it will be run again: " + line(verdict->graderFault);
  }
  if (explanation.state == State::Passed || explanation.state == State::GraderFault) return explanation;

  const Manifest& manifest = exercise.manifest;
  if (manifest.feedback != FeedbackLevel::Criterion) explanation.mistakes = mistakesOf(*verdict, manifest);
  explanation.fault = line(verdict->fault);
  explanation.tests = failedTests(*verdict, manifest.feedback);
  if (explanation.mistakes.empty()) explanation.hint = line(criterion.hint);
  return explanation;
}

std::string shownOutput(const Criterion& criterion, const GradedExercise& exercise) {
  const Verdict* verdict = verdictOf(criterion, exercise);
  if (verdict == nullptr || exercise.manifest.feedback != FeedbackLevel::Values) return "";
  return cut(printableText(verdict->output), outputBytes);
}

}  // namespace muelle::grader
