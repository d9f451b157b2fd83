#include "base/text/printable.h"
#include "base/text/utf8.h"
#include "base/text/wrap.h"
#include "grader/report/followed.h"
#include "grader/report/format.h"
#include "grader/report/paint.h"
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
constexpr int diagnosticLinesShown = 8;
constexpr std::size_t diagnosticBytesShown = 800;
constexpr std::size_t nameBytes = 200;      ///< a name or a title: about three lines
constexpr std::size_t sentenceBytes = 480;  ///< a sentence or a note: about six lines
constexpr std::size_t mostNotes = 12;

class Table {
 public:
  Table(bool colour, int width) : colour_(colour), width_(std::clamp(width, narrowest, widest)) {}

  void submission(const GradedSubmission& graded) {
    row("", graded.name, pointsOf(showScore(graded), maxScore(graded)), paint::bold);
    for (const GradedExercise& exercise : graded.exercises) this->exercise(exercise);
    text_ += std::string(static_cast<std::size_t>(width_), '-') + '\n';
    row("", "total", pointsOf(showScore(graded), maxScore(graded)), paint::bold);
    if (hasGraderFault(graded))
      paragraph("", "the grader failed on part of this: the total is no score; run it again", paint::yellow);
    paragraph("", "sandbox: " + showSandbox(graded), paint::dim);
    notes(graded.intakeNotes);
  }

  std::string text() && { return std::move(text_); }

 private:
  static std::string pointsOf(const std::string& points, double most) {
    return fmt::format("{} / {}", points, showPoints(most));
  }

  std::string painted(const std::string& text, const char* code) const {
    return paint::painted(text, colour_ ? code : paint::none);
  }

  /// Mark and name at the left, points at the right edge; a long name goes on below.
  void row(const std::string& mark, const std::string& name, const std::string& points, const char* code) {
    const int nameWidth = width_ - pointsWidth - columns(mark);
    std::vector<std::string> lines = wrap(cut(printableLine(name), nameBytes), nameWidth);
    if (lines.empty()) lines.emplace_back();
    const int gap = nameWidth - columns(lines.front());
    const std::string padding(static_cast<std::size_t>(std::max(gap, 0)), ' ');
    text_ += painted(mark + lines.front(), code) + padding + painted(fmt::format("{:>{}}", points, pointsWidth), code) +
             '\n';
    for (std::size_t i = 1; i < lines.size(); ++i) {
      text_ += std::string(static_cast<std::size_t>(columns(mark)), ' ') + painted(lines[i], code) + '\n';
    }
  }

  /// Text of a submission is in it: it must be a few lines, however long that text is.
  void paragraph(const std::string& indent, const std::string& line, const char* code) {
    for (const std::string& piece : wrap(cut(printableLine(line), sentenceBytes), width_ - columns(indent)))
      text_ += indent + painted(piece, code) + '\n';
  }

  void exercise(const GradedExercise& exercise) {
    text_ += '\n';
    row("", fmt::format("{}  {}", exercise.manifest.topic, exercise.manifest.title),
        pointsOf(showScore(exercise), maxScore(exercise)), paint::bold);
    if (!exercise.note.empty()) paragraph("  ", "note: " + exercise.note, paint::dim);
    if (exercise.build.status != BuildOutcome::Status::Built) return unbuilt(exercise);
    for (const Criterion& criterion : exercise.manifest.criteria) this->criterion(criterion, exercise);
    for (const std::string& sentence : followedSentences(exercise)) paragraph("  ", sentence, paint::dim);
  }

  /// One line for all criteria: none of them ran.
  void unbuilt(const GradedExercise& exercise) {
    if (exercise.manifest.criteria.empty()) return;
    const bool ours = exercise.build.status == BuildOutcome::Status::GraderFault;
    paragraph("  ", feedback(exercise.manifest.criteria.front(), exercise).front(), ours ? paint::yellow : paint::red);
    const std::string words = printableText(exercise.build.diagnostics);
    const std::string kept = cutText(words, diagnosticLinesShown, diagnosticBytesShown);
    std::istringstream shown(kept);
    for (std::string line; std::getline(shown, line);) paragraph("    ", line, paint::dim);
    if (kept != words) paragraph("    ", "all of it stands in report.html", paint::dim);
  }

  void notes(const std::vector<std::string>& all) {
    for (std::size_t i = 0; i < std::min(all.size(), mostNotes); ++i) paragraph("", "note: " + all[i], paint::dim);
    if (all.size() > mostNotes)
      paragraph("", fmt::format("... and {} more notes in report.html", all.size() - mostNotes), paint::dim);
  }

  void criterion(const Criterion& criterion, const GradedExercise& exercise) {
    const State state = explain(criterion, exercise).state;
    const char* code = state == State::Passed                             ? paint::green
                       : state == State::Failed || state == State::NotRun ? paint::red
                                                                          : paint::yellow;
    row(fmt::format("  {} ", showMark(state)), criterion.name,
        fmt::format("{} / {}", showScore(criterion, exercise), showPoints(criterion.points)), code);
    if (state == State::Passed) return;  // at most the note, which stands under the exercise
    const std::vector<std::string> lines = feedback(criterion, exercise);
    if (!lines.empty()) paragraph("      ", lines.front(), paint::dim);
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
