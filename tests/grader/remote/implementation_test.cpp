#include "grader/testing/implementation.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using muelle::grader::Implementation;
using muelle::grader::implementationsOf;

double half(double x) {
  if (x < 0) throw std::domain_error("negative");
  return x / 2;
}

const Implementation wrong("wrong/half", "values", "is half as large", {{"twice", &half}});

TEST(Implementation, AnswersAsTheSubmissionDoes) {
  EXPECT_FALSE(wrong.isRight());
  EXPECT_TRUE(Implementation("right/plain", "plain", "", {}).isRight());
  EXPECT_EQ(wrong.function<double(double)>("twice")(3), 1.5);
}

TEST(Implementation, ThrowsToWhoAsksWithoutItsOwnWords) {
  const auto twice = wrong.function<double(double)>("twice");
  try {
    twice(-1);
    FAIL() << "it threw";
  } catch (const muelle::ThrownToAsker& thrown) {
    EXPECT_EQ(std::string(thrown.what()).find("negative"), std::string::npos) << "a corpus stays hidden";
  }
}

TEST(Implementation, RefusesAnotherNameAndAnotherSignature) {
  EXPECT_THROW(wrong.function<double(double)>("thrice"), std::out_of_range);
  EXPECT_THROW(wrong.function<double(int)>("twice"), std::bad_any_cast);
}

TEST(Implementation, StandsInTheListOfItsExercise) {
  const muelle::grader::ImplementationRegistration added("doubling", wrong);
  ASSERT_EQ(implementationsOf("doubling").size(), 1U);
  EXPECT_EQ(implementationsOf("doubling").front().says(), "is half as large");
  EXPECT_TRUE(implementationsOf("nothing").empty());
}

}  // namespace
