#include "grader/report/format.h"

#include "base/text/lists.h"
#include "base/text/printable.h"

#include <fmt/format.h>

namespace muelle::grader {

std::string showPoints(double points) {
  std::string text = fmt::format("{:.2f}", points);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string showScore(const Criterion& criterion, const GradedExercise& exercise) {
  const std::optional<double> points = score(criterion, exercise);
  return points ? showPoints(*points) : "no score";
}

std::string showScore(const GradedExercise& exercise) {
  return hasGraderFault(exercise) ? "no score" : showPoints(score(exercise));
}

std::string showScore(const GradedSubmission& graded) {
  return hasGraderFault(graded) ? "no score" : showPoints(score(graded));
}

std::string showState(Explanation::State state) {
  switch (state) {
    case Explanation::State::Passed:
      return "passed";
    case Explanation::State::Partial:
      return "in part";
    case Explanation::State::Failed:
      return "failed";
    case Explanation::State::NotRun:
      return "not run";
    case Explanation::State::GraderFault:
      break;
  }
  return "grader's fault";
}

const char* showMark(Explanation::State state) {
  switch (state) {
    case Explanation::State::Passed:
      return "✓";
    case Explanation::State::Partial:
      return "~";
    case Explanation::State::GraderFault:
      return "!";
    case Explanation::State::NotRun:
      return "–";
    case Explanation::State::Failed:
      break;
  }
  return "✗";
}

double maxScore(const GradedExercise& exercise) {
  double sum = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) sum += criterion.points;
  return sum;
}

std::string seedSentence(const GradedExercise& exercise) {
  if (exercise.seed == 0) return "";
  return fmt::format("Seed of the inputs of {}: {}", printableLine(exercise.manifest.title), exercise.seed);
}

std::string showSandbox(const std::string& sandbox) { return sandbox.empty() ? "none known" : printableLine(sandbox); }
std::string showSandbox(const GradedSubmission& graded) { return showSandbox(graded.sandbox); }

std::string field(const std::string& text) {
  constexpr std::size_t ellipsis = 3;
  return cut(printableText(text), fieldBytes - ellipsis);
}

std::string fieldLine(const std::string& text) {
  constexpr std::size_t ellipsis = 3;
  return cut(printableLine(text), fieldBytes - ellipsis);
}

std::string feedbackText(const Criterion& criterion, const GradedExercise& exercise) {
  return joined(feedback(criterion, exercise), "\n");
}

}  // namespace muelle::grader
