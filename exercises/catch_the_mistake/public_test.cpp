#include "catch_the_mistake.h"
#include "course/testing/expect.h"
#include "course/testing/question_log.h"
#include "wrong_ones.h"

#include <gtest/gtest.h>

// Here everything is wrong, and is to be taken for wrong, but not blindly: a verdict needs a question. Right ones are
// those that you have written for the earlier exercises.

namespace {

using muelle::QuestionLog;

/// The verdict of a function of yours on something wrong, and what it asked.
void expectTakenForWrong(const std::string& name, bool isTakenForRight, const QuestionLog& log) {
  if (log.count() == 0) {
    MUELLE_LABEL("whether you ask anything (1: yes, 0: no) of: " + name);
    EXPECT_NUMBER_NEAR(0.0, 1.0, 0);
    return;
  }
  MUELLE_LABEL("your verdict (1: right, 0: wrong) on: " + name + "; you asked " + log.text());
  EXPECT_NUMBER_NEAR(isTakenForRight ? 1.0 : 0.0, 0.0, 0);
}

std::string shown(const std::string& name) { return "/* " + name + " */"; }

void expectForceTakenForWrong(const Wrong<SpringForce>& wrong) {
  const QuestionLog log;
  const auto force = log.kept("springForceOnA", shown(wrong.name), wrong.implementation);
  expectTakenForWrong(wrong.name, submission::isSpringForceRight(force), log);
}

void expectGradientTakenForWrong(const Wrong<EnergyWithGradient>& wrong) {
  const QuestionLog log;
  const auto& [energy, gradient] = wrong.implementation;
  const auto askedEnergy = log.kept("springEnergy", shown(wrong.name), energy);
  const auto askedGradient = log.kept("energyGradient", "/* its gradient */", gradient);
  expectTakenForWrong(wrong.name, submission::isGradientRight(askedEnergy, askedGradient), log);
}

void expectDampingTakenForWrong(const Wrong<ProjectedDamping>& wrong) {
  const QuestionLog log;
  const auto damping = log.kept("projectedDamping", shown(wrong.name), wrong.implementation);
  expectTakenForWrong(wrong.name, submission::isDampingRight(damping), log);
}

TEST(ForceValues, ThatAreWrong) {
  MUELLE_PROPERTY("no force at all, the same force everywhere and a spring to the origin are taken for wrong");
  for (int i = 0; i < 3; ++i) expectForceTakenForWrong(wrongForces()[static_cast<std::size_t>(i)]);
}

TEST(ForceSides, ThatAreWrong) {
  MUELLE_PROPERTY("a force that is no number where the spring is compressed is taken for wrong");
  expectForceTakenForWrong(wrongForces()[3]);
}

TEST(GradientValues, ThatAreWrong) {
  MUELLE_PROPERTY("a gradient that is the derivative of something else is taken for wrong");
  expectGradientTakenForWrong(wrongGradients()[3]);
}

TEST(WrongTogether, IsSeen) {
  MUELLE_PROPERTY("an energy of no spring is taken for wrong, although the gradient is its derivative");
  for (int i = 0; i < 3; ++i) expectGradientTakenForWrong(wrongGradients()[static_cast<std::size_t>(i)]);
}

TEST(DampingValues, ThatAreWrong) {
  MUELLE_PROPERTY("no damping at all, and forces that are no damping, are taken for wrong");
  for (int i = 0; i < 4; ++i) expectDampingTakenForWrong(wrongDampings()[static_cast<std::size_t>(i)]);
}

TEST(ItThrew, ForEachFunction) {
  MUELLE_PROPERTY("what throws an exception is taken for wrong, and the exception does not leave your function");
  expectForceTakenForWrong(wrongForces().back());
  expectGradientTakenForWrong(wrongGradients().back());
  expectDampingTakenForWrong(wrongDampings().back());
}

}  // namespace
