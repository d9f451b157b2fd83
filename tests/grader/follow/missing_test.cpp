/// \file
/// A function that is missing, static, inline or of another signature costs its own criteria alone.

#include "spring_grading.h"

namespace muelle::grader {
namespace {

using namespace spring_parts;
using Missing = SpringGrading;

/// The criteria that judge springForceOnB.
constexpr const char* ofForceOnB = "ThirdLaw ZeroLength ShortSpring";

std::string withForceOnB(const std::string& function) { return begin + mass + forceOnA + function + hanging + between; }

TEST_F(Missing, AFunctionThatIsNotThereIsNamed) {
  const GradedExercise graded = grade(withForceOnB(""));
  ASSERT_EQ(lost(graded), ofForceOnB) << graded.build.message << graded.build.diagnostics;
  const Verdict& verdict = graded.verdicts.at("ThirdLaw");
  EXPECT_EQ(verdict.outcome, Outcome::Link);
  EXPECT_EQ(verdict.fault, "springForceOnB is missing: spring_1d.cpp does not define it");
}

TEST_F(Missing, AStaticFunctionIsCalledStatic) {
  const GradedExercise graded = grade(withForceOnB("static " + forceOnB));
  EXPECT_EQ(lost(graded), ofForceOnB) << graded.build.message << graded.build.diagnostics;
  EXPECT_NE(graded.verdicts.at("ThirdLaw").fault.find("is static: nothing outside the file can call it; remove static"),
            std::string::npos)
      << graded.verdicts.at("ThirdLaw").fault;
}

TEST_F(Missing, AnInlineFunctionIsCalledInline) {
  const GradedExercise graded = grade(withForceOnB("inline " + forceOnB));
  EXPECT_EQ(lost(graded), ofForceOnB);
  EXPECT_NE(graded.verdicts.at("ThirdLaw").fault.find("is inline"), std::string::npos)
      << graded.verdicts.at("ThirdLaw").fault;
}

TEST_F(Missing, AnotherSignatureIsSaidToBeOne) {
  const GradedExercise graded = grade(withForceOnB(
      "double springForceOnB(double xa, double xb, double k) { return -springForceOnA(xa, xb, k, 1); }\n"));
  EXPECT_EQ(lost(graded), ofForceOnB);
  EXPECT_NE(graded.verdicts.at("ThirdLaw").fault.find("other argument types"), std::string::npos);
}

TEST_F(Missing, WhatIsBuiltOnAMissingFunctionIsJudgedWithTheReferences) {
  const GradedExercise graded = grade(begin + mass + above);
  EXPECT_EQ(lost(graded), "HookeForce CrossedNodes ZeroLength ShortSpring");
}

TEST_F(Missing, AFunctionOfNobodyIsStillAnErrorOfTheWholeFile) {
  const GradedExercise graded = grade("double helper(double);\n" + begin + mass + forceOnA + above +
                                      "double another(double x) { return helper(x); }\n");
  EXPECT_EQ(graded.build.outcome, Outcome::Link);
}

}  // namespace
}  // namespace muelle::grader
