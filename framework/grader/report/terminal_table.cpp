#include "base/text/printable.h"
#include "base/text/utf8.h"
#include "grader/report/format.h"
#include "grader/report/report.h"

#include <fmt/format.h>
#include <algorithm>
#include <sstream>

namespace muelle::grader {

namespace {

using State = Explanation::State;

constexpr int pointsWidth = 14;
constexpr int narrowest = 40;
constexpr int widest = 110;
constexpr std::size_t diagnosticLines = 8;

/// The longest piece of `line` that fits into `width` columns, at least one character; ends at a space when it can.
std::string takeColumns(std::string& line, int width) {
  std::size_t end = 0, space = 0;
  int used = 0;
  while (end < line.size()) {
    const CodePoint point = decodeUtf8(std::string_view(line).substr(end));
    used += columns(point.value);
    if (used > width && end > 0) break;
    if (point.value == ' ') space = end;
    end += point.length;
  }
  if (end < line.size() && space > 0 && line[end] != ' ') end = space;
  std::string piece = line.substr(0, end);
  line.erase(0, line.find_first_not_of(' ', end));
  return piece;
}

std::vector<std::string> wrap(std::string line, int width) {
  std::vector<std::string> pieces;
  while (!line.empty()) pieces.push_back(takeColumns(line, std::max(width, 1)));
  return pieces;
}

class Table {
 public:
  Table(bool colour, int width) : colour_(colour), width_(std::clamp(width, narrowest, widest)) {}

  void submission(const GradedSubmission& graded) {
    row("", graded.name, pointsOf(score(graded), maxScore(graded)), bold);
    for (const GradedExercise& exercise : graded.exercises) this->exercise(exercise);
    text_ += std::string(static_cast<std::size_t>(width_), '-') + '\n';
    row("", "total", pointsOf(score(graded), maxScore(graded)), bold);
    if (hasGraderFault(graded))
      paragraph("", "the grader failed on part of this: the total is no score; run it again", yellow);
    paragraph("", "sandbox: " + showSandbox(graded), dim);
    for (const std::string& note : graded.intakeNotes) paragraph("", "note: " + printableLine(note), dim);
  }

  std::string text() && { return std::move(text_); }

 private:
  static constexpr const char* bold = "1";
  static constexpr const char* dim = "2";
  static constexpr const char* red = "31";
  static constexpr const char* green = "32";
  static constexpr const char* yellow = "33";

  static std::string pointsOf(double points, double most) {
    return fmt::format("{} / {}", showPoints(points), showPoints(most));
  }

  std::string painted(const std::string& text, const char* code) const {
    return colour_ ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
  }

  /// Mark and name at the left, points at the right edge; a long name goes on below.
  void row(const std::string& mark, const std::string& name, const std::string& points, const char* code) {
    const int nameWidth = width_ - pointsWidth - columns(mark);
    std::vector<std::string> lines = wrap(printableLine(name), nameWidth);
    if (lines.empty()) lines.emplace_back();
    const int gap = nameWidth - columns(lines.front());
    const std::string padding(static_cast<std::size_t>(std::max(gap, 0)), ' ');
    text_ += painted(mark + lines.front(), code) + padding + painted(fmt::format("{:>{}}", points, pointsWidth), code) +
             '\n';
    for (std::size_t i = 1; i < lines.size(); ++i) {
      text_ += std::string(static_cast<std::size_t>(columns(mark)), ' ') + painted(lines[i], code) + '\n';
    }
  }

  void paragraph(const std::string& indent, const std::string& line, const char* code) {
    for (const std::string& piece : wrap(line, width_ - columns(indent))) text_ += indent + painted(piece, code) + '\n';
  }

  void exercise(const GradedExercise& exercise) {
    text_ += '\n';
    row("", fmt::format("{}  {}", exercise.manifest.topic, exercise.manifest.title),
        pointsOf(score(exercise), maxScore(exercise)), bold);
    if (exercise.build.status != BuildOutcome::Status::Built) return unbuilt(exercise);
    for (const Criterion& criterion : exercise.manifest.criteria) this->criterion(criterion, exercise);
  }

  /// One line for all criteria: none of them ran.
  void unbuilt(const GradedExercise& exercise) {
    if (exercise.manifest.criteria.empty()) return;
    const bool ours = exercise.build.status == BuildOutcome::Status::GraderFault;
    paragraph("  ", feedback(exercise.manifest.criteria.front(), exercise).front(), ours ? yellow : red);
    std::istringstream diagnostics(printableText(exercise.build.diagnostics));
    std::string line;
    for (std::size_t i = 0; std::getline(diagnostics, line); ++i) {
      if (i == diagnosticLines) return paragraph("    ", "... more in report.html", dim);
      paragraph("    ", line, dim);
    }
  }

  void criterion(const Criterion& criterion, const GradedExercise& exercise) {
    const State state = explain(criterion, exercise).state;
    const char* code = state == State::Passed ? green : state == State::Failed || state == State::NotRun ? red : yellow;
    row(mark(state), criterion.name,
        fmt::format("{} / {}", showScore(criterion, exercise), showPoints(criterion.points)), code);
    const std::vector<std::string> lines = feedback(criterion, exercise);
    if (!lines.empty()) paragraph("      ", lines.front(), dim);
  }

  static std::string mark(State state) {
    switch (state) {
      case State::Passed:
        return "  ✓ ";
      case State::Partial:
        return "  ~ ";
      case State::GraderFault:
        return "  ! ";
      case State::Failed:
      case State::NotRun:
        break;
    }
    return "  ✗ ";
  }

  bool colour_;
  int width_;
  std::string text_;
};

}  // namespace

std::string terminalTable(const GradedSubmission& graded, bool colour, int width) {
  Table table(colour, width);
  table.submission(graded);
  return std::move(table).text();
}

}  // namespace muelle::grader
