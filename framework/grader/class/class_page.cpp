#include "base/text/html.h"
#include "grader/class/class_statistics.h"
#include "grader/class/class_style.h"
#include "grader/class/class_table.h"
#include "grader/class/histogram.h"
#include "grader/report/format.h"
#include "grader/report/page.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

constexpr std::size_t mostHard = 8;
constexpr std::size_t mostMistakes = 8;
constexpr int intervals = 20;

std::string panel(const char* kind, const char* title, const std::string& content) {
  return fmt::format("<section class=\"panel card {}\">\n<h2>{}</h2>\n{}</section>\n", kind, title, content);
}

std::string pageHeader(const GradedClass& graded, const ClassStatistics& statistics) {
  const std::string median = statistics.median ? showPoints(*statistics.median) : "no score";
  return fmt::format(
      "<header class=\"total part\"><div><p class=\"soft\">Muelle: graded class</p><h1>{}</h1><p class=\"soft\">{} "
      "students, {} with points</p></div><p class=\"points\">median <b>{}</b> of {}</p>{}</header>\n",
      escapeHtml(graded.name), graded.rows.size(), static_cast<int>(graded.rows.size()) - graded.faults(), median,
      showPoints(graded.maxPoints()), bar(statistics.median.value_or(0.0), graded.maxPoints()));
}

std::string nameOf(const ClassRow& row) {
  const std::string name = escapeHtml(row.student);
  return row.report.empty() ? name : fmt::format("<a href=\"{}\">{}</a>", relativeLink(row.report), name);
}

/// On top, since somebody must do something about them.
std::string withoutScore(const GradedClass& graded) {
  if (!graded.hasFault()) return "";
  std::string html = "<section class=\"warning\">\n<h2>No score</h2>\n<ul>\n";
  for (const ClassRow& row : graded.rows) {
    if (!row.points()) html += fmt::format("<li>{}: {}</li>\n", nameOf(row), escapeHtml(row.whyNoPoints()));
  }
  return html + "</ul>\n</section>\n";
}

std::string withoutReport(const GradedClass& graded) {
  const std::vector<std::string> lines = graded.missingReports();
  if (lines.empty()) return "";
  std::string html = "<section class=\"warning\">\n<h2>No report</h2>\n<ul>\n";
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", escapeHtml(line));
  return html + "</ul>\n</section>\n";
}

std::string distribution(const GradedClass& graded, const ClassStatistics& statistics) {
  std::vector<double> totals;
  for (const ClassRow& row : graded.rows) {
    if (const std::optional<double> points = row.points()) totals.push_back(*points);
  }
  const Histogram histogram = histogramOf(totals, graded.maxPoints(), intervals);
  if (totals.empty() || histogram.counts.empty()) return "";
  return panel("", "Total points", drawn(histogram, statistics.median));
}

std::string exercises(const GradedClass& graded, const ClassStatistics& statistics) {
  std::string html = "<ul>\n";
  for (std::size_t i = 0; i < graded.course.size(); ++i) {
    const Manifest& manifest = graded.course[i];
    const ExerciseStatistics& exercise = statistics.exercises[i];
    html += fmt::format(
        "<li><span>{}<span class=\"soft\">{}, handed in by {}</span></span>{}<span class=\"points\"><b>{}</b> / "
        "{}</span></li>\n",
        escapeHtml(manifest.title), escapeHtml(manifest.topic), exercise.handedIn,
        bar(exercise.median.value_or(0.0), maxPoints(manifest)),
        exercise.median ? showPoints(*exercise.median) : "no score", showPoints(maxPoints(manifest)));
  }
  return panel("exercises", "Median of each exercise", html + "</ul>\n");
}

std::string hardest(const ClassStatistics& statistics) {
  if (statistics.criteria.empty()) return "";
  std::string html = "<p class=\"soft\">How many passed, of those whose file compiled</p>\n<ul>\n";
  for (std::size_t i = 0; i < std::min(mostHard, statistics.criteria.size()); ++i) {
    const CriterionStatistics& criterion = statistics.criteria[i];
    html += fmt::format(
        "<li><span>{}<span class=\"soft\">{}</span></span>{}<span class=\"points\"><b>{:.0f} %</b> ({} of "
        "{})</span></li>\n",
        escapeHtml(criterion.name), escapeHtml(criterion.topic), bar(criterion.passed, criterion.judged),
        100.0 * criterion.share(), criterion.passed, criterion.judged);
  }
  return panel("hardest", "Hardest criteria", html + "</ul>\n");
}

std::string mistakes(const ClassStatistics& statistics) {
  if (statistics.mistakes.empty()) return "";
  std::string html = "<p class=\"soft\">Students whose numbers are exactly those of a known mistake</p>\n<ul>\n";
  for (std::size_t i = 0; i < std::min(mostMistakes, statistics.mistakes.size()); ++i) {
    const MistakeStatistics& mistake = statistics.mistakes[i];
    html += fmt::format("<li><span class=\"points\"><b>{}</b></span><div>{}<p class=\"soft\">{}, {}</p></div></li>\n",
                        mistake.students, escapeHtml(mistake.says), escapeHtml(mistake.topic), escapeHtml(mistake.id));
  }
  return panel("mistakes", "Commonest mistakes", html + "</ul>\n");
}

std::string tableHead(const GradedClass& graded) {
  std::string html = "<thead>\n<tr><th scope=\"col\">Student</th>";
  for (const Manifest& manifest : graded.course) {
    html += fmt::format("<th scope=\"col\"><span class=\"topic\">{}</span><span class=\"soft\">/ {}</span></th>",
                        escapeHtml(manifest.topic), showPoints(maxPoints(manifest)));
  }
  return html +
         fmt::format("<th scope=\"col\" class=\"sum\">Total<span class=\"soft\">/ {}</span></th></tr>\n</thead>\n",
                     showPoints(graded.maxPoints()));
}

std::string cell(const GradedExercise* exercise) {
  const std::optional<double> points = exercise == nullptr ? std::nullopt : pointsOf(*exercise);
  if (!points) return "<td class=\"none\" title=\"no score\">!</td>";
  if (exercise->build.status == BuildOutcome::Status::Missing)
    return "<td class=\"missing\" title=\"not handed in: 0 points\">–</td>";
  return fmt::format("<td class=\"{}\">{}</td>", classOf(*points, maxPoints(exercise->manifest)), showPoints(*points));
}

std::string tableRow(const ClassRow& row, const GradedClass& graded) {
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", nameOf(row));
  for (const Manifest& manifest : graded.course) html += cell(row.exercise(manifest.topic));
  const std::optional<double> points = row.points();
  return html + (points ? fmt::format("<td class=\"sum\">{}</td></tr>\n", showPoints(*points))
                        : "<td class=\"sum none\">no score</td></tr>\n");
}

std::string students(const GradedClass& graded) {
  std::string html =
      "<p class=\"soft\">Each name leads to the student's report. – not handed in: 0 points; ! no score</p>\n<div "
      "class=\"students-table\">\n<table>\n" +
      tableHead(graded) + "<tbody>\n";
  for (const ClassRow& row : graded.rows) html += tableRow(row, graded);
  return panel("", "Students", html + "</tbody>\n</table>\n</div>\n");
}

}  // namespace

std::string classPage(const GradedClass& graded) {
  const ClassStatistics statistics = statisticsOf(graded);
  const std::string title = fmt::format("{} · {} students", graded.name, graded.rows.size());
  return page(title,
              pageHeader(graded, statistics) + withoutScore(graded) + withoutReport(graded) +
                  distribution(graded, statistics) + exercises(graded, statistics) + hardest(statistics) +
                  mistakes(statistics) + students(graded) +
                  pageFooter(showSandbox(graded.sandbox), "Not graded, because no submission:", graded.notes),
              classStyle);
}

}  // namespace muelle::grader
