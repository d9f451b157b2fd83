#include "base/text/base64.h"
#include "base/text/count.h"
#include "base/text/html.h"
#include "base/text/lists.h"
#include "grader/report/followed.h"
#include "grader/report/format.h"
#include "grader/report/mending.h"
#include "grader/report/page.h"
#include "grader/report/report.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

using State = Explanation::State;

std::string classOfState(State state) {
  if (state == State::Passed) return "passed";
  return state == State::Partial || state == State::GraderFault ? "part" : "failed";
}

std::string pointsOf(const std::string& points, double most, const char* between) {
  return fmt::format("<p class=\"points\"><b>{}</b>{}{}</p>", points, between, showPoints(most));
}

/// Details that a click opens; "" of nothing.
std::string folded(const std::string& summary, const std::string& html, const char* kind = "more") {
  if (html.empty()) return "";
  return fmt::format("<details class=\"{}\"><summary>{}</summary>\n{}</details>\n", kind, escapeHtml(summary), html);
}

/// Got and expected side by side; a statement as it is.
std::string failure(const Explanation::Failure& failure) {
  std::string html = paragraph("call", failure.call);
  if (failure.words.got.empty()) return html + paragraph("other", failure.sentence);
  html += paragraph("what", failure.words.what);
  return html + fmt::format(
                    "<dl><dt>got</dt><dd class=\"got\">{}</dd><dt>expected</dt><dd><span class=\"wanted\">{}</span>"
                    "<span class=\"rest\">{}</span></dd></dl>\n",
                    escapeHtml(failure.words.got), escapeHtml(failure.words.expected),
                    failure.words.bounds.empty() ? "" : fmt::format(" ({})", escapeHtml(failure.words.bounds)));
}

std::string failedTest(const Explanation::FailedTest& test) {
  std::string html = "<div class=\"test\">\n" + paragraph("property", test.property);
  if (test.failures.empty()) return html + "</div>\n";
  html += "<div class=\"values\">\n" + failure(test.failures.front());
  std::string rest;
  for (std::size_t i = 1; i < test.failures.size(); ++i) rest += failure(test.failures[i]);
  rest += paragraph("other", test.more);
  return html +
         folded(counted(static_cast<long long>(test.failures.size()) - 1, "more number that is off",
                        "more numbers that are off"),
                rest) +
         "</div>\n</div>\n";
}

/// The first test that failed; the others folded.
std::string failedTests(const std::vector<Explanation::FailedTest>& tests) {
  if (tests.empty()) return "";
  std::string rest;
  for (std::size_t i = 1; i < tests.size(); ++i) rest += failedTest(tests[i]);
  return failedTest(tests.front()) + folded(counted(static_cast<long long>(tests.size()) - 1,
                                                    "more test that does not pass", "more tests that do not pass"),
                                            rest);
}

/// Where the exercise's block of things to mend has said the cause, the rest is folded.
std::string why(const Explanation& explanation, const std::string& printed) {
  std::string html = paragraph("cause", explanation.neverWritten) + paragraph("cause", explanation.fault);
  for (const auto& mistake : explanation.mistakes) html += paragraph("cause", mistake.says);
  html += paragraph("soft", explanation.instead) + paragraph("hint", explanation.hint);
  if (explanation.mistakes.empty()) {
    for (const std::string& example : explanation.examples) html += paragraph("example", example);
  }
  html += failedTests(explanation.tests);
  if (!printed.empty()) html += folded("What your code printed", fmt::format("<pre>{}</pre>\n", escapeHtml(printed)));
  if (explanation.hasCause()) html = folded("explained above; the numbers", html);
  return html.empty() ? "" : "<div class=\"why\">\n" + html + "</div>\n";
}

std::string criterionRow(const Criterion& criterion, const GradedExercise& exercise, const Explanation& explanation) {
  const bool built = exercise.build.status == BuildOutcome::Status::Built;
  return fmt::format("<div class=\"criterion {}\"><span class=\"mark\" title=\"{}\">{}</span><h3>{}</h3>{}\n{}</div>\n",
                     classOfState(explanation.state), showState(explanation.state), showMark(explanation.state),
                     escapeHtml(criterion.name), pointsOf(showScore(criterion, exercise), criterion.points, " / "),
                     // A build that failed is told once, above the criteria.
                     built ? why(explanation, shownOutput(criterion, exercise)) : "");
}

/// Those that are lost, then those that passed, folded into one line.
std::string criteriaRows(const GradedExercise& exercise) {
  std::string lost, passed;
  long long passedCount = 0;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    const Explanation explanation = explain(criterion, exercise);
    const bool hasPassed = explanation.state == State::Passed;
    (hasPassed ? passed : lost) += criterionRow(criterion, exercise, explanation);
    passedCount += hasPassed ? 1 : 0;
  }
  return lost +
         folded(fmt::format("\u2713 {} passed", counted(passedCount, "criterion", "criteria")), passed, "passed");
}

std::string mending(const Mending& mending) {
  const std::string costs =
      fmt::format("Costs {}: {}", counted(static_cast<long long>(mending.criteria.size()), "criterion", "criteria"),
                  joined(mending.criteria, "; "));
  return fmt::format("<li class=\"{}\">\n", mending.isNamed ? "mistake" : "fault") + paragraph("says", mending.says) +
         paragraph("hint", mending.hint) + paragraph("example", mending.example) + paragraph("soft", costs) + "</li>\n";
}

/// What a student reads first: each thing to mend, once.
std::string mendingBlock(const GradedExercise& exercise) {
  if (exercise.build.status != BuildOutcome::Status::Built) return "";
  std::string items;
  for (const Mending& each : mendingsOf(exercise)) items += mending(each);
  for (const std::string& sentence : followedSentences(exercise))
    items += "<li>" + paragraph("soft", sentence) + "</li>\n";
  return items.empty() ? ""
                       : "<div class=\"block\">\n<h3>To mend</h3>\n<ul class=\"mend\">\n" + items + "</ul>\n</div>\n";
}

std::string buildBlock(const GradedExercise& exercise) {
  if (exercise.build.status == BuildOutcome::Status::Built || exercise.manifest.criteria.empty()) return "";
  const Explanation explanation = explain(exercise.manifest.criteria.front(), exercise);
  const bool ours = exercise.build.status == BuildOutcome::Status::GraderFault;
  std::string html = "<div class=\"block\">\n" + paragraph(ours ? "mistake" : "fault", explanation.instead);
  if (!exercise.build.diagnostics.empty())
    html += fmt::format("<pre>{}</pre>\n", escapeHtml(exercise.build.diagnostics));
  return html + "</div>\n";
}

std::string curves(const GradedExercise& exercise) {
  if (exercise.figures.empty() && exercise.figuresNote.empty()) return "";
  std::string html = "<div class=\"block\">\n" + paragraph("soft", exercise.figuresNote);
  if (!exercise.figures.empty()) html += "<div class=\"curves\">\n";
  for (const std::string& svg : exercise.figures) {
    html += fmt::format("<img alt=\"Curves of {}: yours over the reference\" src=\"data:image/svg+xml;base64,{}\">\n",
                        escapeHtml(exercise.manifest.title), base64(svg));
  }
  return html + (exercise.figures.empty() ? "</div>\n" : "</div>\n</div>\n");
}

std::string exerciseSection(const GradedExercise& exercise) {
  const double points = score(exercise), most = maxScore(exercise);
  const bool ours = hasGraderFault(exercise);
  std::string html = fmt::format(
      "<section class=\"exercise card\" id=\"{0}\">\n<header class=\"{1}\"><h2>{2}</h2>{3}<p "
      "class=\"soft\">{0}</p>{4}</header>\n",
      escapeHtml(exercise.manifest.topic), ours ? "part" : classOf(points, most), escapeHtml(exercise.manifest.title),
      pointsOf(showScore(exercise), most, " / "), bar(points, most));
  if (!exercise.note.empty()) html += "<div class=\"block\">\n" + paragraph("soft", exercise.note) + "</div>\n";
  html += buildBlock(exercise) + mendingBlock(exercise) + criteriaRows(exercise) + curves(exercise);
  if (exercise.seed != 0) html += "<div class=\"block\">\n" + paragraph("soft", seedSentence(exercise)) + "</div>\n";
  return html + "</section>\n";
}

/// "2026-03-14 09:26 UTC, " of "2026-03-14T09:26:53Z"; any other text as it is.
std::string showDate(const std::string& date) {
  if (date.empty()) return "";
  if (date.size() != 20 || date[10] != 'T' || date[19] != 'Z') return date + ", ";
  return date.substr(0, 10) + ' ' + date.substr(11, 5) + " UTC, ";
}

std::string pageHeader(const GradedSubmission& graded) {
  const double points = score(graded), most = maxScore(graded);
  const std::string html = fmt::format(
      "<header class=\"total {}\"><div><p class=\"soft\">Muelle: graded submission</p><h1>{}</h1>"
      "<p class=\"soft\">{}graded in {:.1f} s</p></div>{}{}</header>\n",
      hasGraderFault(graded) ? "part" : classOf(points, most), escapeHtml(graded.name),
      escapeHtml(showDate(graded.date)), graded.seconds, pointsOf(showScore(graded), most, " of "), bar(points, most));
  return html + paragraph("warning", hasGraderFault(graded) ? faultSentence : "");
}

/// Under the exercise's line: what to mend, so that the first screen says it.
std::string toMend(const GradedExercise& exercise) {
  std::string items;
  for (const std::string& line : firstLines(exercise)) items += fmt::format("<li>{}</li>\n", escapeHtml(line));
  return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

std::string overview(const GradedSubmission& graded) {
  std::string html = "<nav class=\"overview card\">\n";
  for (const GradedExercise& exercise : graded.exercises) {
    const double points = score(exercise), most = maxScore(exercise);
    html += fmt::format(
        "<div><a class=\"{}\" href=\"#{}\"><span>{}</span>{}<span class=\"points\"><b>{}</b> / "
        "{}</span></a>\n{}</div>\n",
        hasGraderFault(exercise) ? "part" : classOf(points, most), escapeHtml(exercise.manifest.topic),
        escapeHtml(exercise.manifest.title), bar(points, most), showScore(exercise), showPoints(most),
        toMend(exercise));
  }
  return html + "</nav>\n";
}

}  // namespace

std::string htmlPage(const GradedSubmission& graded) {
  std::string body = pageHeader(graded) + overview(graded);
  for (const GradedExercise& exercise : graded.exercises) body += exerciseSection(exercise);
  return page(fmt::format("{} / {} · {}", showScore(graded), showPoints(maxScore(graded)), graded.name),
              body + pageFooter(showSandbox(graded), "Of the submission:", graded.intakeNotes));
}

}  // namespace muelle::grader
