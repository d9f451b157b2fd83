#include "base/text/utf8.h"
#include "grader/report/report.h"
#include "sample.h"
#include "support/lines.h"

#include <gtest/gtest.h>
#include <sstream>

namespace muelle::grader {
namespace {

TEST(TerminalTable, ShowsPointsCriteriaAndTheFirstLineOfTheFeedback) {
  const std::string text = terminalTable(sampleSubmission(), false, 100);
  for (const char* part :
       {"9 / 35", "spring_3d  A spring in three dimensions", "2 / 7", "  ✓ Hooke's force on both nodes",
        "  ~ Acceleration under gravity", "Your force has the right size and the wrong sign",
        "segmentation fault in springForce", "damping.cpp was not handed in", "'normal' was not declared in this scope",
        "sandbox: bubblewrap", "note: ignored in spring_1d/: CMakeLists.txt"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

TEST(TerminalTable, AlignsThePointsAtTheRightEdge) {
  for (const int width : {40, 72, 100}) {
    for (const std::string& line : linesOf(terminalTable(sampleSubmission(), false, width))) {
      EXPECT_LE(columns(line), width) << line;
      if (line.ends_with(" / 35") || line.ends_with(" / 7") || line.ends_with(" / 4")) {
        EXPECT_EQ(columns(line), width);
      }
    }
  }
}

TEST(TerminalTable, HasEscapesOnlyInColour) {
  const std::string plain = terminalTable(sampleSubmission(), false, 80);
  const std::string coloured = terminalTable(sampleSubmission(), true, 80);
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
  EXPECT_NE(coloured.find("\x1b[32m"), std::string::npos);
}

TEST(TerminalTable, TellsTheGradersFault) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[0].verdicts.at("HookeForce").graderFault = "disk full";
  const std::string text = terminalTable(graded, false, 90);
  EXPECT_NE(text.find("no score / 4"), std::string::npos);
  EXPECT_NE(text.find("the total is no score; run it again"), std::string::npos);
}

TEST(TerminalTable, NoScoreOfTheWholeWithoutEveryRecord) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[0].verdicts.erase("HookeForce");
  const std::string text = terminalTable(graded, false, 110);
  EXPECT_NE(text.find("no score / 35"), std::string::npos);
  EXPECT_NE(text.find("no score / 7"), std::string::npos);
  EXPECT_NE(text.find("no record of this criterion: the grader failed, not you; run the same command again"),
            std::string::npos)
      << text;
}

TEST(TerminalTable, ShowsHowTheFileWasTaken) {
  GradedSubmission graded = sampleSubmission();
  for (GradedExercise& exercise : graded.exercises) exercise.note = "taken from " + exercise.manifest.topic;
  const std::string text = terminalTable(graded, false, 110);
  const std::size_t first = text.find("note: taken from spring_1d");
  EXPECT_EQ(text.find("note: taken from spring_1d", first + 1), std::string::npos) << "once is enough\n" << text;
  EXPECT_NE(text.find("  note: taken from spring_1d\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  note: taken from damping\n"), std::string::npos) << "of a file that was not handed in";
}

TEST(TerminalTable, IsNotFilledByAnyMessage) {
  const std::string symbol(100'000, 'x');
  std::string lines;
  for (int i = 0; i < 10'000; ++i) lines += "y\n";
  for (const std::string& text : {symbol, lines, symbol + '\n' + symbol}) {
    GradedSubmission graded = hostileSubmission(text);
    graded.intakeNotes.assign(400, text);
    EXPECT_LT(linesOf(terminalTable(graded, false, 80)).size(), 200U);
    EXPECT_LT(linesOf(terminalTable(hostileSubmission(text), false, 80)).size(), 80U);
  }
}

TEST(TerminalTable, ShowsAnyTextAsTextAndInsideItsWidth) {
  for (const std::string& text : hostileTexts()) {
    for (const std::string& line : linesOf(terminalTable(hostileSubmission(text), false, 80))) {
      EXPECT_EQ(line.find_first_of(std::string("\0\x1b\r\x07\x7f", 5)), std::string::npos);
      EXPECT_LE(columns(line), 80) << line;
    }
  }
}

}  // namespace
}  // namespace muelle::grader
