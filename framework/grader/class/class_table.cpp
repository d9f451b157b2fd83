#include "grader/class/class_table.h"

#include "base/text/count.h"
#include "base/text/printable.h"
#include "base/text/utf8.h"
#include "base/text/wrap.h"
#include "grader/class/class_statistics.h"
#include "grader/report/format.h"
#include "grader/report/paint.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

constexpr int narrowest = 40;
constexpr int widest = 160;
constexpr int shortestName = 12;
constexpr std::size_t headingEvery = 40;  ///< rows; on the screen there is always a heading, or nearly
constexpr std::size_t hardestShown = 3;
constexpr std::size_t mistakesShown = 3;
constexpr std::size_t mostNotes = 10;
constexpr std::size_t noteBytesShown = 300;

constexpr const char* missingMark = "-";
constexpr const char* faultMark = "!";

/// A number at the right edge of its column.
struct Cell {
  std::string text;
  const char* code = "";
};

/// A line of the table.
struct Line {
  Cell name;
  std::vector<Cell> exercises;
  Cell total;
};

const char* codeOf(double points, double most) {
  return points >= most ? paint::green : points > 0.0 ? "" : paint::red;
}

Cell cellOf(const GradedExercise* exercise) {
  const std::optional<double> points = exercise == nullptr ? std::nullopt : pointsOf(*exercise);
  if (!points) return {faultMark, paint::yellow};
  if (exercise->build.status == BuildOutcome::Status::Missing) return {missingMark, paint::dim};
  return {showPoints(*points), codeOf(*points, maxPoints(exercise->manifest))};
}

Cell cellOf(const std::optional<double>& points) { return {points ? showPoints(*points) : "", paint::bold}; }

Line lineOf(const ClassRow& row, const GradedClass& graded) {
  const std::optional<double> points = row.points();
  Line line{{printableLine(row.student)}, {}, points ? cellOf(points) : Cell{"no score", paint::yellow}};
  for (const Manifest& manifest : graded.course) line.exercises.push_back(cellOf(row.exercise(manifest.topic)));
  return line;
}

/// The exercises stand there as 1, 2, 3: their topics are too long for a column.
std::vector<Line> heading(const GradedClass& graded) {
  std::vector<Line> lines(2);
  for (const Manifest& manifest : graded.course) {
    lines[0].exercises.push_back({std::to_string(lines[0].exercises.size() + 1), paint::bold});
    lines[1].exercises.push_back({"/ " + showPoints(maxPoints(manifest)), paint::dim});
  }
  lines[0].name = {"student", paint::bold};
  lines[0].total = {"total", paint::bold};
  lines[1].total = {"/ " + showPoints(graded.maxPoints()), paint::dim};
  return lines;
}

std::vector<Line> summary(const ClassStatistics& statistics, const GradedClass& graded) {
  std::vector<Line> lines(2);
  lines[0].name = {"median", paint::bold};
  lines[0].total = cellOf(statistics.median);
  lines[1].name = {"handed in", paint::dim};
  lines[1].total = {std::to_string(graded.rows.size()), paint::dim};
  for (const ExerciseStatistics& exercise : statistics.exercises) {
    lines[0].exercises.push_back(cellOf(exercise.median));
    lines[1].exercises.push_back({std::to_string(exercise.handedIn), paint::dim});
  }
  return lines;
}

/// Widths of the columns: names get what the numbers leave.
class Columns {
 public:
  Columns(const std::vector<Line>& lines, int width) {
    for (const Line& line : lines) {
      longestName_ = std::max(longestName_, columns(line.name.text));
      total_ = std::max(total_, columns(line.total.text));
      exercises_.resize(std::max(exercises_.size(), line.exercises.size()));
      for (std::size_t i = 0; i < line.exercises.size(); ++i)
        exercises_[i] = std::max(exercises_[i], columns(line.exercises[i].text));
    }
    for (gap_ = 2; gap_ > 1 && width - numbers() < std::min(longestName_, 2 * shortestName);) --gap_;
    if (width - numbers() < shortestName) exercises_.clear();
    name_ = std::clamp(longestName_, 1, std::max(width - numbers(), 1));
  }

  int name() const { return name_; }
  int gap() const { return gap_; }
  int total() const { return total_; }
  /// Empty when the terminal is too narrow for them.
  const std::vector<int>& exercises() const { return exercises_; }
  int all() const { return name_ + numbers(); }

 private:
  int numbers() const {
    int sum = gap_ + total_;
    for (const int exercise : exercises_) sum += gap_ + exercise;
    return sum;
  }

  int longestName_ = 0;
  int name_ = 0;
  int total_ = 0;
  int gap_ = 2;
  std::vector<int> exercises_;
};

class Table {
 public:
  Table(const GradedClass& graded, bool colour, int width)
      : graded_(graded),
        statistics_(statisticsOf(graded)),
        colour_(colour),
        width_(std::clamp(width, narrowest, widest)) {}

  std::string text() {
    students();
    exercises();
    hardest();
    mistakes();
    withoutScore();
    list("no report", graded_.missingReports(), "mend what is broken, then type the same command again", paint::yellow);
    notes();
    return std::move(text_);
  }

 private:
  std::string painted(const std::string& text, const std::string& code) const {
    return paint::painted(text, colour_ ? code : paint::none);
  }

  void students() {
    const std::vector<Line> head = heading(graded_), foot = summary(statistics_, graded_);
    std::vector<Line> rows;
    for (const ClassRow& row : graded_.rows) rows.push_back(lineOf(row, graded_));
    std::vector<Line> all = head;
    all.insert(all.end(), foot.begin(), foot.end());
    all.insert(all.end(), rows.begin(), rows.end());
    const Columns columns(all, width_);

    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i % headingEvery == 0) add(head, columns);
      add(rows[i], columns);
    }
    text_ += std::string(static_cast<std::size_t>(columns.all()), '-') + '\n';
    add(foot, columns);
    showsExercises_ = !columns.exercises().empty();
  }

  void add(const std::vector<Line>& lines, const Columns& columns) {
    for (const Line& line : lines) add(line, columns);
  }

  void add(const Line& line, const Columns& columns) {
    text_ += painted(fitted(line.name.text, columns.name()), line.name.code);
    for (std::size_t i = 0; i < columns.exercises().size(); ++i)
      add(line.exercises[i], columns.gap() + columns.exercises()[i]);
    add(line.total, columns.gap() + columns.total());
    text_ += '\n';
  }

  void add(const Cell& cell, int width) { text_ += painted(fmt::format("{:>{}}", cell.text, width), cell.code); }

  /// What the heading's numbers and the marks stand for.
  void exercises() {
    text_ += '\n';
    if (!showsExercises_)
      return paragraph("", "(too narrow for the points of each exercise: they are in grades.csv)", paint::dim);
    for (std::size_t i = 0; i < graded_.course.size(); ++i) {
      const Manifest& manifest = graded_.course[i];
      paragraph("    ", fmt::format("{:>2}  {}  {}", i + 1, manifest.topic, manifest.title), "");
    }
    paragraph("    ", fmt::format(" {}  not handed in: 0 points", missingMark), paint::dim);
    if (graded_.hasFault()) paragraph("    ", fmt::format(" {}  no score, see below", faultMark), paint::yellow);
  }

  void hardest() {
    if (statistics_.criteria.empty()) return;
    title("hardest criteria (how many passed, of those whose file compiled)");
    for (std::size_t i = 0; i < std::min(hardestShown, statistics_.criteria.size()); ++i) {
      const CriterionStatistics& criterion = statistics_.criteria[i];
      paragraph("    ",
                fmt::format("{} of {}  {} ({})", criterion.passed, criterion.judged, criterion.name, criterion.topic));
    }
  }

  void mistakes() {
    if (statistics_.mistakes.empty()) return;
    title("commonest mistakes");
    for (std::size_t i = 0; i < std::min(mistakesShown, statistics_.mistakes.size()); ++i) {
      const MistakeStatistics& mistake = statistics_.mistakes[i];
      const std::string who = counted(mistake.students, "student");
      const std::string says = mistake.says.empty() ? "" : ": " + mistake.says;
      paragraph("    ", fmt::format("{}  {} ({}){}", who, mistake.id, mistake.topic, says));
    }
  }

  void withoutScore() {
    std::vector<std::string> lines;
    for (const ClassRow& row : graded_.rows) {
      if (!row.points()) lines.push_back(fmt::format("{}: {}", row.student, row.whyNoPoints()));
    }
    list("no score", lines, "all are in grades.csv", paint::yellow);
  }

  void notes() { list("not graded, because no submission", graded_.notes, "all are in class.html", ""); }

  void list(const std::string& name, const std::vector<std::string>& lines, const char* rest, const char* code) {
    if (lines.empty()) return;
    title(name);
    for (std::size_t i = 0; i < std::min(mostNotes, lines.size()); ++i) paragraph("    ", lines[i], code);
    if (lines.size() > mostNotes)
      paragraph("    ", fmt::format("... and {} more; {}", lines.size() - mostNotes, rest), paint::dim);
  }

  void title(const std::string& text) {
    text_ += '\n';
    paragraph("", text, paint::bold);
  }

  /// Continued lines stand under the first one's text.
  void paragraph(const std::string& indent, const std::string& line, const char* code = "") {
    for (const std::string& piece : wrap(cut(printableLine(line), noteBytesShown), width_ - columns(indent)))
      text_ += indent + painted(piece, code) + '\n';
  }

  const GradedClass& graded_;
  ClassStatistics statistics_;
  bool colour_;
  int width_;
  bool showsExercises_ = true;
  std::string text_;
};

}  // namespace

std::string classTable(const GradedClass& graded, bool colour, int width) {
  return Table(graded, colour, width).text();
}

}  // namespace muelle::grader
