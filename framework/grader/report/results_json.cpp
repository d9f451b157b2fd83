// Gradescope's results.json: https://gradescope-autograders.readthedocs.io/en/latest/specs/

#include "base/text/printable.h"
#include "grader/report/followed.h"
#include "grader/report/format.h"
#include "grader/report/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

using Json = nlohmann::ordered_json;

/// So that the words of one exercise's compiler leave room for the next one's.
constexpr std::size_t messageBytes = 500;
constexpr int diagnosticLines = 30;
constexpr std::size_t diagnosticBytes = 2000;

Json testJson(const Criterion& criterion, const GradedExercise& exercise, const std::string& number) {
  const Explanation::State state = explain(criterion, exercise).state;
  std::string output = feedbackText(criterion, exercise);
  const std::string printed = shownOutput(criterion, exercise);
  if (!printed.empty()) output += "\n\nYour code printed:\n" + printed;

  Json test;
  const std::optional<double> points = score(criterion, exercise);
  if (points) test["score"] = *points;
  test["max_score"] = criterion.points;
  test["status"] = state == Explanation::State::Passed ? "passed" : "failed";
  test["name"] = fieldLine(exercise.manifest.title + ": " + criterion.name);
  test["name_format"] = "text";
  test["number"] = number;
  test["output"] = field(output);
  test["output_format"] = "text";
  test["visibility"] = "visible";
  return test;
}

std::string summary(const GradedSubmission& graded) {
  std::string text;
  if (hasGraderFault(graded)) text += fmt::format("{}\n", faultSentence);
  text += fmt::format("Sandbox: {}\n", showSandbox(graded));
  for (const std::string& note : graded.intakeNotes) text += printableLine(note) + '\n';
  for (const GradedExercise& exercise : graded.exercises) {
    for (const std::string& sentence : followedSentences(exercise)) {
      text += fmt::format("\n{}: {}\n", printableLine(exercise.manifest.title), sentence);
    }
    if (exercise.seed != 0) text += seedSentence(exercise) + '\n';
    if (exercise.build.diagnostics.empty()) continue;
    text += fmt::format("\n{}: {}\n{}\n", printableLine(exercise.manifest.title),
                        cut(printableLine(exercise.build.message), messageBytes),
                        cutText(printableText(exercise.build.diagnostics), diagnosticLines, diagnosticBytes));
  }
  return field(text);
}

}  // namespace

std::string resultsJson(const GradedSubmission& graded) {
  Json json;
  // Without a score of its own the file says that there is none yet.
  if (!hasGraderFault(graded)) json["score"] = score(graded);
  json["execution_time"] = graded.seconds;
  json["output"] = summary(graded);
  json["output_format"] = "text";
  json["visibility"] = "visible";
  json["tests"] = Json::array();
  for (std::size_t e = 0; e < graded.exercises.size(); ++e) {
    const GradedExercise& exercise = graded.exercises[e];
    for (std::size_t c = 0; c < exercise.manifest.criteria.size(); ++c) {
      json["tests"].push_back(testJson(exercise.manifest.criteria[c], exercise, fmt::format("{}.{}", e + 1, c + 1)));
    }
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace muelle::grader
