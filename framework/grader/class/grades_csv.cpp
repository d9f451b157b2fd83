#include "base/text/csv.h"
#include "base/text/lists.h"
#include "base/text/printable.h"
#include "grader/class/class_statistics.h"
#include "grader/class/class_table.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

constexpr std::size_t noteBytes = 400;

/// Nothing stays nothing, without quotes, so that a spreadsheet finds an empty cell.
std::string cell(const std::string& text) { return text.empty() ? "" : untrustedCsvField(text); }

std::string noteCell(const std::string& note) { return cell(cut(printableLine(note), noteBytes)); }

/// Four decimals at most: with the two that a report shows, thirds would not add up to the total.
std::string number(double points) {
  std::string text = fmt::format("{:.4f}", points);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// What one criterion of one student got.
struct Grade {
  std::optional<double> points;
  std::string mistakes;  ///< ids, with blanks between them
  std::string note;
};

Grade gradeOf(const Criterion& criterion, const GradedExercise& exercise) {
  const std::vector<std::string> lines = feedback(criterion, exercise);
  return {score(criterion, exercise), joined(mistakesOf(criterion, exercise), " "), lines.empty() ? "" : lines.front()};
}

/// A hand-in that cannot be read has a line for each criterion too: whoever adds up columns finds all students there.
Grade gradeOf(const ClassRow& row, const Manifest& manifest, const Criterion& criterion) {
  if (row.trouble) return {std::nullopt, "", *row.trouble};
  const GradedExercise* exercise = row.exercise(manifest.topic);
  return exercise == nullptr ? Grade{std::nullopt, "", "not graded"} : gradeOf(criterion, *exercise);
}

std::string line(const ClassRow& row, const Manifest& manifest, const Criterion& criterion) {
  const Grade grade = gradeOf(row, manifest, criterion);
  return fmt::format("{},{},{},{},{},{},{}\n", untrustedCsvField(row.student), csvField(manifest.topic),
                     csvField(criterion.name), grade.points ? number(*grade.points) : "", number(criterion.points),
                     cell(grade.mistakes), noteCell(grade.note));
}

}  // namespace

std::string gradesCsv(const GradedClass& graded) {
  std::string csv = "student,exercise,criterion,points,max,mistake,note\n";
  for (const ClassRow& row : graded.rows) {
    for (const Manifest& manifest : graded.course) {
      for (const Criterion& criterion : manifest.criteria) csv += line(row, manifest, criterion);
    }
  }
  return csv;
}

}  // namespace muelle::grader
