#include "grader/class/class_table.h"
#include "base/text/utf8.h"
#include "base/text/words.h"
#include "sample_class.h"

#include "support/hostile_texts.h"
#include "support/lines.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <sstream>

namespace muelle::grader {
namespace {

std::string lineWith(const std::string& text, const std::string& start) {
  for (const std::string& line : linesOf(text)) {
    if (line.starts_with(start)) return line;
  }
  return "no line begins with " + start;
}

TEST(ClassTable, HasALineAStudentAndTheMedians) {
  const std::string text = classTable(
      classOfOneExercise({student(1, {4, 0}, {3, 0}), student(2, {4, 0}, {1, 1}), studentWithoutFile(3)}), false, 80);
  EXPECT_EQ(lineWith(text, "student 01"), "student 01    7      7");
  EXPECT_EQ(lineWith(text, "student 02"), "student 02  5.5    5.5");
  EXPECT_EQ(lineWith(text, "student 03"), "student 03    -      0");
  EXPECT_EQ(lineWith(text, "median"), "median      5.5    5.5");
  EXPECT_EQ(lineWith(text, "handed in"), "handed in     2      3");
  EXPECT_TRUE(contains(text, "1  spring_1d  A spring in one dimension"));
  EXPECT_FALSE(contains(text, "no score"));
}

TEST(ClassTable, NamesWhatWasHardestAndCommonest) {
  const std::string text = classTable(
      classOfOneExercise({withMistake(student(1, {0, 1}, {3, 0}), "wrong_sign"), student(2, {4, 0}, {3, 0})}), false,
      100);
  EXPECT_TRUE(contains(text, "1 of 2  Hooke's force on both nodes (spring_1d)"));
  EXPECT_TRUE(contains(text, "1 student  wrong_sign (spring_1d): Your force has the right size")) << text;
}

TEST(ClassTable, SaysWhoHasNoScoreAndWhatIsNoSubmission) {
  GradedClass graded =
      classOfOneExercise({unreadable(1, "the archive is broken"), withFault(student(2, {4, 0}, {3, 0}), "disk full")});
  graded.notes = {"list.xlsx is no submission"};
  const std::string text = classTable(graded, false, 100);
  EXPECT_EQ(lineWith(text, "student 01"), "student 01    !  no score");
  EXPECT_EQ(lineWith(text, "student 02"), "student 02    !  no score");
  EXPECT_TRUE(contains(text, "    student 01: the archive is broken"));
  EXPECT_TRUE(contains(text, "disk full"));
  EXPECT_TRUE(contains(text, "    list.xlsx is no submission"));
}

TEST(ClassTable, FitsItsWidth) {
  for (const int width : {40, 60, 80, 120, 400}) {
    for (const std::string& line : linesOf(classTable(sampleClass(60), false, width)))
      EXPECT_LE(columns(line), width) << line;
  }
}

TEST(ClassTable, CutsANameThatLeavesNoRoomForThePoints) {
  GradedClass graded = sampleClass(3);
  graded.rows[1].student = std::string(200, 'x');
  const std::string line = lineWith(classTable(graded, false, 60), "xxxx");
  EXPECT_EQ(columns(line), 60);
  EXPECT_TRUE(contains(line, "x…"));
  EXPECT_EQ(columns(lineWith(classTable(graded, false, 60), "student 01")), 60);
}

TEST(ClassTable, ANarrowTerminalShowsTheTotalsAlone) {
  GradedClass graded = sampleClass(2);
  const std::vector<Manifest> half = graded.course;
  graded.course.insert(graded.course.end(), half.begin(), half.end());
  const std::string text = classTable(graded, false, 40);
  EXPECT_EQ(linesOf(text)[0].find('1'), std::string::npos);
  EXPECT_TRUE(contains(text, "too narrow"));
}

TEST(ClassTable, AClassOf300StaysReadable) {
  GradedClass graded = sampleClass(300);
  for (ClassRow& row : graded.rows) row.trouble = "the disk is full";
  const auto lines = linesOf(classTable(graded, false, 100));
  EXPECT_EQ(std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("student  "); }), 8);
  EXPECT_EQ(std::ranges::count_if(lines, [](const auto& line) { return line.ends_with(": the disk is full"); }), 10);
  EXPECT_EQ(std::ranges::count(lines, "    ... and 290 more; all are in grades.csv"), 1);
  EXPECT_LE(lines.size(), 350u);
}

TEST(ClassTable, HasEscapesOnlyInColour) {
  EXPECT_EQ(classTable(sampleClass(30), false, 80).find('\x1b'), std::string::npos);
  EXPECT_TRUE(contains(classTable(sampleClass(30), true, 80), "\x1b[32m"));
}

TEST(ClassTable, ShowsAnyTextAsTextAndInsideItsWidth) {
  for (const std::string& text : hostileTexts()) {
    const auto lines = linesOf(classTable(hostileClass(text), false, 80));
    EXPECT_LE(lines.size(), 80u);
    for (const std::string& line : lines) {
      EXPECT_EQ(line.find_first_of(std::string("\0\x1b\r\x07\x7f", 5)), std::string::npos);
      EXPECT_LE(columns(line), 80) << line;
    }
  }
}

}  // namespace
}  // namespace muelle::grader
