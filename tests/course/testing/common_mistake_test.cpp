/// \file
/// A common mistake is named only when it explains every number.

#include "course/testing/common_mistake.h"

#include "course/testing/expect.h"

#include <gtest/gtest.h>
#include <array>
#include <limits>

namespace muelle {
namespace {

using Three = std::array<double, 3>;
constexpr Three right{-60, 0, -80};

TEST(CommonFactor, IsOfTheIdOrOfItsEnd) {
  EXPECT_EQ(commonFactor("wrong_sign"), -1.0);
  EXPECT_EQ(commonFactor("plane_wrong_sign"), -1.0);
  EXPECT_EQ(commonFactor("missing_half"), 2.0);
  EXPECT_EQ(commonFactor("half_kept"), 0.5);
  EXPECT_EQ(commonFactor("relative_half"), 0.5);
  EXPECT_FALSE(commonFactor("threshold"));
  EXPECT_FALSE(commonFactor("behalf")) << "ends so, and is another word";
  EXPECT_FALSE(commonFactor(""));
}

TEST(Answers, OfTheOppositeSignAreNamed) {
  Answers answers;
  answers.add(Three{60, 0, 80}, right, 1e-9);
  EXPECT_EQ(answers.factor(), -1.0);
}

TEST(Answers, OfHalfTheSizeAreNamed) {
  Answers answers;
  answers.add(Three{-30, 0, -40}, right, 1e-9);
  EXPECT_EQ(answers.factor(), 0.5);
}

TEST(Answers, ThatAreRightAreNoMistake) {
  Answers answers;
  answers.add(right, right, 1e-9);
  EXPECT_FALSE(answers.factor());
}

TEST(Answers, OneOfWhichIsOtherwiseAreNotNamed) {
  Answers answers;
  answers.add(Three{60, 0, 80}, right, 1e-9);
  answers.add(std::array{-5.0}, std::array{-5.0}, 1e-9);  // a right one
  EXPECT_FALSE(answers.factor());
}

TEST(Answers, OfOneNumberAreNotEnough) {
  Answers answers;
  answers.add(std::array{100.0}, std::array{-100.0}, 1e-9);
  EXPECT_FALSE(answers.factor());
}

TEST(Answers, ThatAreNoNumbersAreNotNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Answers answers;
  answers.add(Three{nan, nan, nan}, right, 1e-9);
  EXPECT_FALSE(answers.factor());
}

TEST(NoteComparison, TakesOneCallAndNothingElse) {
  comparedAnswers().clear();
  for (const char* source : {"submission::f(a, g(b))[0]", "-submission::f(a)", "f(a)", "submission::f(a) - f(b)"}) {
    noteComparison(source, Three{60, 0, 80}, right, 1e-9);
  }
  EXPECT_TRUE(comparedAnswers().empty());
  noteComparison("submission::f(a, g(b))", Three{60, 0, 80}, right, 1e-9);
  ASSERT_EQ(comparedAnswers().size(), 1U);
  EXPECT_EQ(comparedAnswers().at("f").factor(), -1.0);
}

namespace submission {
Vec3 force() { return {60, 0, 80}; }
}  // namespace submission

TEST(NoteComparison, IsCalledByTheExpectations) {
  comparedAnswers().clear();
  EXPECT_TRUE(matrixNear("submission::force()", "", "", submission::force(), Vec3(60, 0, 80), 1e-9));
  EXPECT_FALSE(comparedAnswers().at("force").factor());
  EXPECT_FALSE(numberNear("submission::energy(x)", "", "", 2.0, 1.0, 1e-9));
  EXPECT_FALSE(numberNear("submission::energy(x)", "", "", 6.0, 3.0, 1e-9));
  EXPECT_EQ(comparedAnswers().at("energy").factor(), 2.0);
}

}  // namespace
}  // namespace muelle
