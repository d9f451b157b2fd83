#include "grader/class/class_statistics.h"
#include "sample_class.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

TEST(GradedClass, ARowWithoutScoreHasNoPoints) {
  EXPECT_EQ(student(1, {4, 0}, {2, 1}).points(), 6.0);
  EXPECT_EQ(studentWithoutFile(1).points(), 0.0);
  EXPECT_EQ(unreadable(1, "broken").points(), std::nullopt);
  EXPECT_EQ(withFault(student(1, {4, 0}, {3, 0}), "disk full").points(), std::nullopt);
}

TEST(GradedClass, CountsItsRowsWithoutScoreAndSaysWhy) {
  const GradedClass graded = classOfOneExercise(
      {student(1, {4, 0}, {3, 0}), unreadable(2, "bad\nchecksum"), withFault(student(3, {4, 0}, {3, 0}), "disk full")});
  EXPECT_EQ(graded.faults(), 2);
  EXPECT_EQ(graded.maxPoints(), 7.0);
  EXPECT_EQ(graded.rows[0].whyNoPoints(), "");
  EXPECT_EQ(graded.rows[1].whyNoPoints(), "bad\\nchecksum");
  EXPECT_NE(graded.rows[2].whyNoPoints().find("spring_1d: the grader failed"), std::string::npos);
  EXPECT_NE(graded.rows[2].whyNoPoints().find("disk full"), std::string::npos);
}

TEST(ClassStatistics, MediansLeaveOutWhoHasNoScore) {
  const ClassRow full = student(1, {4, 0}, {3, 0}), six = student(2, {4, 0}, {2, 1}), none = studentWithoutFile(3);
  EXPECT_EQ(statisticsOf(classOfOneExercise({full, none, six})).median, 6.0);
  const ClassStatistics even = statisticsOf(classOfOneExercise({full, six, unreadable(4, "broken")}));
  EXPECT_EQ(even.median, 6.5);
  EXPECT_EQ(even.exercises.at(0).median, 6.5);
  EXPECT_EQ(even.exercises.at(0).handedIn, 2);
  EXPECT_EQ(statisticsOf(classOfOneExercise({unreadable(4, "broken")})).median, std::nullopt);
}

TEST(ClassStatistics, TheHardestCriterionIsTheOneThatTheLeastShareOfThoseJudgedPassed) {
  const GradedClass graded =
      classOfOneExercise({student(1, {4, 0}, {2, 1}), student(2, {3, 1}, {2, 1}), student(3, {4, 0}, {3, 0}),
                          studentWithoutFile(4), withFault(student(5, {4, 0}, {0, 3}), "disk full")});
  const auto criteria = statisticsOf(graded).criteria;
  ASSERT_EQ(criteria.size(), 2u);
  EXPECT_EQ(criteria[0].name, "Acceleration under gravity");
  EXPECT_EQ(criteria[0].passed, 1);
  EXPECT_EQ(criteria[0].judged, 3);
  EXPECT_EQ(criteria[1].passed, 3);
  EXPECT_EQ(criteria[1].judged, 4);
}

TEST(ClassStatistics, ACriterionThatAllPassedIsNotHard) {
  EXPECT_TRUE(statisticsOf(classOfOneExercise({student(1, {4, 0}, {3, 0})})).criteria.empty());
  EXPECT_TRUE(statisticsOf(classOfOneExercise({studentWithoutFile(1)})).criteria.empty());
}

TEST(ClassStatistics, CountsAMistakeOnceAStudent) {
  ClassRow twice = withMistake(withMistake(student(1, {0, 2}, {3, 0}), "wrong_sign"), "wrong_sign");
  const GradedClass graded = classOfOneExercise({withMistake(student(2, {0, 1}, {3, 0}), "no_words"), std::move(twice),
                                                 withMistake(student(3, {0, 1}, {3, 0}), "wrong_sign")});
  const auto mistakes = statisticsOf(graded).mistakes;
  ASSERT_EQ(mistakes.size(), 2u);
  EXPECT_EQ(mistakes[0].id, "wrong_sign");
  EXPECT_EQ(mistakes[0].students, 2);
  EXPECT_NE(mistakes[0].says.find("the wrong sign"), std::string::npos);
  EXPECT_EQ(mistakes[1].says, "");
}

}  // namespace
}  // namespace muelle::grader
