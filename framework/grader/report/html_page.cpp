#include "base/text/base64.h"
#include "base/text/html.h"
#include "grader/report/followed.h"
#include "grader/report/format.h"
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

std::string markOf(State state) {
  switch (state) {
    case State::Passed:
      return "✓";
    case State::Partial:
      return "~";
    case State::GraderFault:
      return "!";
    case State::NotRun:
      return "–";
    case State::Failed:
      break;
  }
  return "✗";
}

std::string pointsOf(const std::string& points, double most, const char* between) {
  return fmt::format("<p class=\"points\"><b>{}</b>{}{}</p>", points, between, showPoints(most));
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
  html += "<div class=\"values\">\n";
  for (const Explanation::Failure& each : test.failures) html += failure(each);
  return html + paragraph("other", test.more) + "</div>\n</div>\n";
}

std::string mistake(const Explanation::Mistake& mistake) {
  return "<div class=\"mistake\">\n<p class=\"label\">Your numbers are exactly those of a known mistake</p>\n" +
         paragraph("says", mistake.says) + paragraph("hint", mistake.hint) + "</div>\n";
}

std::string why(const Explanation& explanation, const std::string& printed) {
  std::string html = paragraph("soft", explanation.instead) + paragraph("fault", explanation.neverWritten);
  for (const auto& m : explanation.mistakes) html += mistake(m);
  html += paragraph("fault", explanation.fault);
  for (const auto& test : explanation.tests) html += failedTest(test);
  html += paragraph("hint", explanation.hint);
  if (!printed.empty())
    html +=
        fmt::format("<details><summary>What your code printed</summary><pre>{}</pre></details>\n", escapeHtml(printed));
  return html.empty() ? "" : "<div class=\"why\">\n" + html + "</div>\n";
}

std::string criterionRow(const Criterion& criterion, const GradedExercise& exercise) {
  const Explanation explanation = explain(criterion, exercise);
  const bool built = exercise.build.status == BuildOutcome::Status::Built;
  return fmt::format("<div class=\"criterion {}\"><span class=\"mark\" title=\"{}\">{}</span><h3>{}</h3>{}\n{}</div>\n",
                     classOfState(explanation.state), showState(explanation.state), markOf(explanation.state),
                     escapeHtml(criterion.name), pointsOf(showScore(criterion, exercise), criterion.points, " / "),
                     // A build that failed is told once, above the criteria.
                     built ? why(explanation, shownOutput(criterion, exercise)) : "");
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

std::string followedBlock(const GradedExercise& exercise) {
  std::string html;
  for (const std::string& sentence : followedSentences(exercise)) html += paragraph("hint", sentence);
  return html.empty() ? "" : "<div class=\"block\">\n" + html + "</div>\n";
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
  html += followedBlock(exercise) + buildBlock(exercise);
  for (const Criterion& criterion : exercise.manifest.criteria) html += criterionRow(criterion, exercise);
  return html + curves(exercise) + "</section>\n";
}

/// "2026-03-14 09:26 UTC, " of "2026-03-14T09:26:53Z"; any other text as it is.
std::string showDate(const std::string& date) {
  if (date.empty()) return "";
  if (date.size() != 20 || date[10] != 'T' || date[19] != 'Z') return date + ", ";
  return date.substr(0, 10) + ' ' + date.substr(11, 5) + " UTC, ";
}

std::string pageHeader(const GradedSubmission& graded) {
  const double points = score(graded), most = maxScore(graded);
  std::string html = fmt::format(
      "<header class=\"total {}\"><div><p class=\"soft\">Muelle: graded submission</p><h1>{}</h1>"
      "<p class=\"soft\">{}graded in {:.1f} s</p></div>{}{}</header>\n",
      hasGraderFault(graded) ? "part" : classOf(points, most), escapeHtml(graded.name),
      escapeHtml(showDate(graded.date)), graded.seconds, pointsOf(showScore(graded), most, " of "), bar(points, most));
  if (hasGraderFault(graded))
    html +=
        "<p class=\"warning\">The grader failed on part of this submission. That is not your fault: there is no "
        "score yet, and it will be run again.</p>\n";
  return html;
}

std::string overview(const GradedSubmission& graded) {
  std::string html = "<nav class=\"overview card\">\n";
  for (const GradedExercise& exercise : graded.exercises) {
    const double points = score(exercise), most = maxScore(exercise);
    html +=
        fmt::format("<a class=\"{}\" href=\"#{}\"><span>{}</span>{}<span class=\"points\"><b>{}</b> / {}</span></a>\n",
                    hasGraderFault(exercise) ? "part" : classOf(points, most), escapeHtml(exercise.manifest.topic),
                    escapeHtml(exercise.manifest.title), bar(points, most), showScore(exercise), showPoints(most));
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
