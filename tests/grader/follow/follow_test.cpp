/// \file
/// What is right given the student's own earlier function is earned, and nothing is earned by a function that is of no
/// use.

#include "grader/report/followed.h"
#include "spring_grading.h"

namespace muelle::grader {
namespace {

using namespace spring_parts;
using Follow = SpringGrading;

std::string forceReturning(const std::string& value) {
  return "double springForceOnA(double xa, double xb, double k, double L0) { " + value + " }\n";
}

constexpr const char* ownCriteria = "HookeForce CrossedNodes";
constexpr const char* everythingOfForces =
    "HookeForce CrossedNodes ThirdLaw ZeroLength ShortSpring HangingNode NodeBetween Oscillator";

/// Half of the force.
const std::string halved =
    forceReturning("const double L = std::abs(xa - xb); return L == 0 ? 0 : -k / 2 * (L - L0) * (xa - xb) / L;");

TEST_F(Follow, OneMistakeCostsTheCriteriaOfItsOwnFunction) {
  const GradedExercise graded = grade(begin + mass + halved + above);
  EXPECT_EQ(lost(graded), ownCriteria);
  EXPECT_EQ(score(graded), 7.0);
  EXPECT_EQ(
      followedSentences(graded),
      std::vector<std::string>{"one mistake, in springForceOnA, costs these 3 points; what you built on it is right."});
}

TEST_F(Follow, TheReferencesFunctionIsTheOneThatTheStudentsCalls) {
  const GradedExercise graded = grade(begin + mass + halved + above);
  EXPECT_EQ(followed(graded, "Oscillator").front(), "springForceOnA");
  EXPECT_TRUE(graded.verdicts.at("Oscillator").passed());
}

TEST_F(Follow, WhatUsesAHelperOfItsOwnIsHeldAgainstTheStudentsOwnAnswers) {
  const std::string helper =
      "static double half(double xa, double xb, double k, double L0) {\n"
      "  const double L = std::abs(xa - xb);\n"
      "  return L == 0 ? 0 : -k / 2 * (L - L0) * (xa - xb) / L;\n"
      "}\n";
  const std::string hangsOnHelper =
      "double hangingAcceleration(double x, double m, const Attachment& top, double g) {\n"
      "  return half(x, top.x, top.k, top.L0) / m - g;\n"
      "}\n";
  const GradedExercise graded =
      grade(begin + helper + mass + forceReturning("return half(xa, xb, k, L0);") + forceOnB + hangsOnHelper + between);
  EXPECT_FALSE(followed(graded, "HangingNode").empty());
  EXPECT_EQ(lost(graded).find("HangingNode"), std::string::npos) << lost(graded);
}

TEST_F(Follow, AMistakeOfItsOwnIsNotForgiven) {
  const std::string wrongHanging =
      "double hangingAcceleration(double x, double m, const Attachment& top, double g) {\n"
      "  return springForceOnA(x, top.x, top.k, top.L0) / m + g;\n"
      "}\n";
  const GradedExercise graded = grade(begin + mass + halved + forceOnB + wrongHanging + between);
  EXPECT_EQ(lost(graded), std::string(ownCriteria) + " HangingNode Oscillator");
}

TEST_F(Follow, NothingIsEarnedByZeroConstantNoNumberOrState) {
  for (const std::string body : {"return 0;", "return 7;", "return std::nan(\"\");",
                                 "static int calls = 0; return -k * (xa - xb - L0) + ++calls;"}) {
    const GradedExercise graded = grade(begin + mass + forceReturning(body) + above);
    EXPECT_EQ(lost(graded), everythingOfForces) << body;
    EXPECT_EQ(followedSentences(graded), std::vector<std::string>()) << body;
  }
}

TEST_F(Follow, WithoutAnArgumentAForceIsOfUseOnlyAsANamedMistake) {
  // The rest length is left out, which is a listed mistake; nobody has listed the square of the stiffness for k L0.
  const std::string listed =
      forceReturning("const double L = std::abs(xa - xb); return L == 0 ? 0 : -k * L * (xa - xb) / L;");
  EXPECT_EQ(lost(grade(begin + mass + listed + above)), ownCriteria);
  const std::string unlisted =
      forceReturning("const double L = std::abs(xa - xb); return L == 0 ? 0 : -k * k * L * L * (xa - xb);");
  EXPECT_EQ(lost(grade(begin + mass + unlisted + above)),
            "HookeForce CrossedNodes ThirdLaw HangingNode NodeBetween Oscillator");
}

TEST_F(Follow, OfTheRunsThatAskItNothingIsShown) {
  const std::string talking = forceReturning(
      "std::printf(\"asked %g\\n\", xa); const double L = std::abs(xa - xb); return L == 0 ? 0 : -k / 2 * (L - L0) * "
      "(xa "
      "- xb) / L;");
  const GradedExercise graded = grade("#include <cstdio>\n" + begin + mass + talking + above);
  const Verdict& verdict = graded.verdicts.at("NodeBetween");
  ASSERT_FALSE(verdict.followed.empty());
  // 12 cases of two springs and some more: with the second run's the output would be longer by the questions of use.
  const GradedExercise other = grade("#include <cstdio>\n" + begin + mass + talking + forceOnB + hanging +
                                     "double accelerationBetween(double, double, const Attachment&, const Attachment&, "
                                     "double) { return 1; }\n");
  EXPECT_EQ(other.verdicts.at("NodeBetween").output.find("asked"), std::string::npos)
      << other.verdicts.at("NodeBetween").output;
}

TEST_F(Follow, AnUnchangedRegradeStartsNothing) {
  const std::string source = begin + mass + halved + above;
  const GradedExercise first = grade(source);
  EXPECT_GT(startedSince(), 0);
  const GradedExercise second = grade(source);
  EXPECT_EQ(startedSince(), 0);
  EXPECT_EQ(lost(second), lost(first));
  EXPECT_EQ(followed(second, "HangingNode"), followed(first, "HangingNode"));
}

}  // namespace
}  // namespace muelle::grader
