#include "base/text/escape.h"
#include "grader/report/format.h"
#include "grader/report/report.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0;
};

double secondsOf(const Criterion& criterion, const GradedExercise& exercise) {
  const auto found = exercise.verdicts.find(criterion.suite);
  return found == exercise.verdicts.end() ? 0.0 : found->second.seconds;
}

std::string outcome(const Criterion& criterion, const GradedExercise& exercise, Counts& counts) {
  const Explanation::State state = explain(criterion, exercise).state;
  ++counts.tests;
  if (state == Explanation::State::Passed) return "";
  const bool ours = state == Explanation::State::GraderFault;
  ++(ours ? counts.errors : counts.failures);
  const std::vector<std::string> lines = feedback(criterion, exercise);
  return fmt::format("      <{0} message=\"{1}\" type=\"{2}\">{3}</{0}>\n", ours ? "error" : "failure",
                     escapeXmlAttribute(lines.empty() ? "" : lines.front()), escapeXmlAttribute(showState(state)),
                     escapeXml(feedbackText(criterion, exercise)));
}

std::string testCase(const Criterion& criterion, const GradedExercise& exercise, Counts& counts) {
  std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
                                 escapeXmlAttribute(exercise.manifest.topic), escapeXmlAttribute(criterion.suite),
                                 secondsOf(criterion, exercise));
  text += outcome(criterion, exercise, counts);
  const std::string printed = shownOutput(criterion, exercise);
  if (!printed.empty()) text += fmt::format("      <system-out>{}</system-out>\n", escapeXml(printed));
  return text + "    </testcase>\n";
}

std::string attributes(const Counts& counts) {
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\"", counts.tests, counts.failures,
                     counts.errors);
}

std::string testSuite(const GradedExercise& exercise, const std::string& date, Counts& total) {
  Counts counts;
  std::string cases;
  double seconds = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    cases += testCase(criterion, exercise, counts);
    seconds += secondsOf(criterion, exercise);
  }
  total = {total.tests + counts.tests, total.failures + counts.failures, total.errors + counts.errors};
  return fmt::format("  <testsuite name=\"{}\" {} time=\"{:.3f}\" timestamp=\"{}\">\n{}  </testsuite>\n",
                     escapeXmlAttribute(exercise.manifest.topic), attributes(counts), seconds, escapeXmlAttribute(date),
                     cases);
}

}  // namespace

std::string junitXml(const GradedSubmission& graded) {
  Counts total;
  std::string suites;
  for (const GradedExercise& exercise : graded.exercises) suites += testSuite(exercise, graded.date, total);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {} time=\"{:.3f}\">\n{}</testsuites>\n",
      escapeXmlAttribute(graded.name), attributes(total), graded.seconds, suites);
}

}  // namespace muelle::grader
