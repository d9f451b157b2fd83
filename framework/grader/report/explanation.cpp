#include "grader/report/explanation.h"

#include "base/text/printable.h"
#include "course/testing/never_written.h"
#include "grader/report/example_sentence.h"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>

namespace muelle::grader {

namespace {

using State = Explanation::State;

constexpr std::size_t shownFailures = 4;
constexpr std::size_t shownBytes = 2000;
constexpr std::size_t outputBytes = 8 * 1024;

std::string line(const std::string& text) { return cut(printableLine(text), shownBytes); }

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
  return "";
}

/// The criterion's state when the exercise was built and its record counts.
State stateOf(const Criterion& criterion, const GradedExercise& exercise) {
  if (verdictOf(criterion, exercise)->passed()) return State::Passed;
  return score(criterion, exercise).value_or(0.0) > 0.0 ? State::Partial : State::Failed;
}

/// In the manifest's order of functions: one that another is made of stands first.
std::vector<Explanation::Mistake> mistakesOf(const Verdict& verdict) {
  std::vector<Explanation::Mistake> mistakes;
  for (const NamedMistake& named : verdict.mistakes) mistakes.push_back({line(named.says), line(named.hint)});
  return mistakes;
}

MismatchWords printable(const MismatchWords& words) {
  return {line(words.what), line(words.got), line(words.expected), line(words.bounds)};
}

/// The first few failures, each under its call; the call alone when nothing was compared before the test ended.
std::vector<Explanation::Failure> failuresOf(const TestOutcome& test) {
  if (test.mismatches.empty() && !test.call.empty()) return {{line(test.call), {}, ""}};
  std::vector<Explanation::Failure> failures;
  std::string before;
  for (std::size_t i = 0; i < std::min(test.mismatches.size(), shownFailures); ++i) {
    const Mismatch& mismatch = test.mismatches[i];
    const std::string& call = mismatch.call.empty() && i == 0 ? test.call : mismatch.call;
    failures.push_back({call == before ? "" : line(call), printable(wordsOf(mismatch)), line(sentence(mismatch))});
    before = call;
  }
  return failures;
}

std::string moreOf(const TestOutcome& test) {
  return test.mismatches.size() > shownFailures ? fmt::format("... and {} more", test.mismatches.size() - shownFailures)
                                                : "";
}

std::vector<Explanation::FailedTest> failedTests(const Verdict& verdict, FeedbackLevel level) {
  std::vector<Explanation::FailedTest> failed;
  if (level == FeedbackLevel::Criterion) return failed;
  for (const TestOutcome& test : verdict.tests) {
    if (test.passed) continue;
    Explanation::FailedTest shown{line(test.name), line(test.property.empty() ? test.name : test.property), {}, ""};
    if (level == FeedbackLevel::Values) {
      shown.failures = failuresOf(test);
      shown.more = moreOf(test);
    }
    failed.push_back(std::move(shown));
  }
  return failed;
}

}  // namespace

Explanation explain(const Criterion& criterion, const GradedExercise& exercise) {
  Explanation explanation;
  explanation.note = line(exercise.note);
  if (const std::string fault = graderFault(criterion, exercise); !fault.empty()) {
    explanation.state = State::GraderFault;
    explanation.instead = line(fault);
    return explanation;
  }
  explanation.instead = unbuilt(exercise);
  if (!explanation.instead.empty()) return explanation;

  explanation.state = stateOf(criterion, exercise);
  if (explanation.state == State::Passed) return explanation;
  const Verdict& verdict = *verdictOf(criterion, exercise);
  const Manifest& manifest = exercise.manifest;
  if (verdict.outcome == Outcome::NeverWritten && verdict.fault.empty())  // else that says it
    explanation.neverWritten =
        line(fmt::format("{} {}", verdict.neverWritten.empty() ? "it" : verdict.neverWritten, neverWrittenSentence()));
  if (manifest.feedback != FeedbackLevel::Criterion) explanation.mistakes = mistakesOf(verdict);
  explanation.fault = line(verdict.fault);
  if (manifest.feedback == FeedbackLevel::Values) {
    for (const CounterExample& example : verdict.examples)
      explanation.examples.push_back(line(exampleSentence(example)));
  }
  explanation.tests = failedTests(verdict, manifest.feedback);
  if (explanation.mistakes.empty()) explanation.hint = line(criterion.hint);
  return explanation;
}

std::string shownOutput(const Criterion& criterion, const GradedExercise& exercise) {
  const Verdict* verdict = verdictOf(criterion, exercise);
  if (verdict == nullptr || exercise.manifest.feedback != FeedbackLevel::Values) return "";
  return cut(printableText(verdict->output), outputBytes);
}

}  // namespace muelle::grader
