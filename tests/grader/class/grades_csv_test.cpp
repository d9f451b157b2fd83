#include "grader/class/class_table.h"
#include "sample_class.h"

#include "support/hostile_texts.h"
#include "support/lines.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <sstream>

namespace muelle::grader {
namespace {

/// The fields of one line (RFC 4180).
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[++i];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

using Fields = std::vector<std::string>;

TEST(GradesCsv, HasALineForEachCriterionOfEachStudent) {
  const auto lines = linesOf(gradesCsv(classOfOneExercise(
      {student(2, {4, 0}, {3, 0}), withMistake(withMistake(student(1, {1, 1}, {2, 1}), "wrong_sign"), "factor")})));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "student,exercise,criterion,points,max,mistake,note");
  EXPECT_EQ(fieldsOf(lines[1]), (Fields{"student 02", "spring_1d", "Hooke's force on both nodes", "4", "4", "", ""}));
  EXPECT_EQ(fieldsOf(lines[2]), (Fields{"student 02", "spring_1d", "Acceleration under gravity", "3", "3", "", ""}));
  const Fields mistaken = fieldsOf(lines[3]);
  EXPECT_EQ(mistaken[0], "student 01");
  EXPECT_EQ(mistaken[3], "0");
  EXPECT_EQ(mistaken[5], "wrong_sign factor");
  EXPECT_NE(mistaken[6].find("the wrong sign"), std::string::npos);
  EXPECT_EQ(fieldsOf(lines[4])[3], "2");
}

TEST(GradesCsv, PointsAddUpToTheTotal) {
  GradedClass graded = classOfOneExercise({student(1, {4, 0}, {5, 4})});
  double sum = 0.0;
  for (const std::string& line : linesOf(gradesCsv(graded))) {
    if (!line.starts_with("student,")) sum += std::stod(fieldsOf(line)[3]);
  }
  EXPECT_NEAR(sum, *graded.rows[0].points(), 1e-4);
  EXPECT_EQ(fieldsOf(linesOf(gradesCsv(graded))[2])[3], "1.6667");
}

TEST(GradesCsv, WhatWasNotHandedInHasNoPointsAndSaysSo) {
  const auto lines = linesOf(gradesCsv(classOfOneExercise({studentWithoutFile(1)})));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(fieldsOf(lines[1])[3], "0");
  EXPECT_EQ(fieldsOf(lines[1])[6], "spring_1d.cpp was not handed in");
}

TEST(GradesCsv, WithoutScoreThePointsAreEmptyAndTheNoteSaysWhy) {
  const auto lines = linesOf(gradesCsv(classOfOneExercise(
      {unreadable(1, "the archive is broken"), withFault(student(2, {4, 0}, {3, 0}), "disk full")})));
  ASSERT_EQ(lines.size(), 5u);
  for (const std::size_t i : {1u, 2u}) {
    EXPECT_EQ(fieldsOf(lines[i])[3], "");
    EXPECT_EQ(fieldsOf(lines[i])[6], "the archive is broken");
  }
  EXPECT_EQ(fieldsOf(lines[3])[3], "4");
  EXPECT_EQ(fieldsOf(lines[4])[3], "");
  EXPECT_NE(fieldsOf(lines[4])[6].find("disk full"), std::string::npos);
}

TEST(GradesCsv, TimesDoNotShow) {
  GradedClass graded = sampleClass(30);
  const std::string before = gradesCsv(graded);
  for (ClassRow& row : graded.rows) {
    row.graded.date = "2026-03-14T09:26:53Z";
    row.graded.seconds += 17.0;
    for (GradedExercise& exercise : row.graded.exercises) {
      for (auto& [suite, verdict] : exercise.verdicts) verdict.seconds += 3.0;
    }
  }
  EXPECT_EQ(gradesCsv(graded), before);
}

TEST(GradesCsv, ATextIsNeitherAFormulaNorALineNorAField) {
  const std::size_t lines = linesOf(gradesCsv(hostileClass("plain text"))).size();
  for (const std::string& text : hostileTexts()) {
    const std::string csv = gradesCsv(hostileClass(text));
    EXPECT_EQ(linesOf(csv).size(), lines);
    EXPECT_EQ(csv.find_first_of(std::string("\0\x1b\r\x07", 4)), std::string::npos);
    for (const std::string& line : linesOf(csv)) {
      const Fields fields = fieldsOf(line);
      ASSERT_EQ(fields.size(), 7u) << line.substr(0, 200);
      for (const std::string& field : fields) {
        EXPECT_TRUE(field.empty() || std::string_view("=+-@").find(field[0]) == std::string_view::npos) << field;
      }
      EXPECT_LE(fields[6].size(), 500u);
    }
  }
}

}  // namespace
}  // namespace muelle::grader
