#include "grader/authors/unnamed_groups.h"

#include "grader/naming/name_mistakes.h"
#include "grader/testing/gather_evidence.h"
#include "grader/testing/wrong_answers.h"
#include "spring_history.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

/// What grading for authors says of a submission with this force.
std::vector<UnnamedMistake> unnamed(const ForceFunction& own, int calls = 40) {
  ForceHistory history;
  ask(history, own, calls);
  Verdict verdict;
  verdict.suite = "Force";
  verdict.tests = {{"Fails", "", false, {}, ""}};
  FunctionEvidence& evidence = verdict.evidence["force"] = gatherEvidence(history);
  evidence.answers = sampleOfWrongAnswers(history);
  GradedExercise exercise;
  exercise.build.status = BuildOutcome::Status::Built;
  exercise.manifest.topic = "spring";
  exercise.manifest.criteria.push_back({"Force", "Force", 1.0, false, "", {"force"}, {}});
  exercise.verdicts["Force"] = verdict;
  nameMistakes(exercise, springContract, "");
  return unnamedMistakes(exercise);
}

UnnamedGroup alone(const std::string& name, const ForceFunction& own, int calls = 40) {
  return {"spring", {name}, unnamed(own, calls).at(0), ""};
}

double product(double x, double k, double L0) { return -k * (x * x - L0 * L0); }
double factors(double x, double k, double L0) { return k * (L0 - x) * (L0 + x); }
double cubed(double x, double k, double L0) { return -k * (x * x * x - L0); }

TEST(UnnamedGroups, HoldOneFormulaHoweverItIsWritten) {
  const std::vector<UnnamedGroup> groups =
      joinAlike({alone("other", cubed), alone("product", product), alone("factors", factors)});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].handIns, (std::vector<std::string>{"product", "factors"})) << "the largest first";
  EXPECT_EQ(groups[1].handIns, std::vector<std::string>{"other"});
}

TEST(UnnamedGroups, HoldNoneThatIsNamedAndNoneThatIsRight) {
  EXPECT_TRUE(unnamed([](double x, double k, double L0) { return -rightForce(x, k, L0); }).empty());
  EXPECT_TRUE(unnamed(rightForce).empty());
  EXPECT_EQ(unnamed(product).size(), 1U);
}

TEST(UnnamedGroups, CompareWhatWasAskedOfBoth) {
  // The second ended after ten calls.
  EXPECT_EQ(joinAlike({alone("whole", product), alone("ended", factors, 10)}).size(), 1U);
  EXPECT_EQ(joinAlike({alone("whole", product), alone("ended", cubed, 10)}).size(), 2U);
}

TEST(UnnamedGroups, AreOfOneExerciseAndFunction) {
  UnnamedGroup first = alone("first", product), second = alone("second", product);
  second.topic = "spring_in_3d";
  EXPECT_EQ(joinAlike({first, second}).size(), 2U);
  second = alone("second", product);
  second.mistake.function = "acceleration";
  EXPECT_EQ(joinAlike({first, second}).size(), 2U);
}

TEST(UnnamedGroups, NeedAnswersInCommon) {
  EXPECT_FALSE(errAlike({"force", {}, {}}, {"force", {}, {}}));
  EXPECT_FALSE(errAlike({"force", {{1, {2.0}, 0}}, {}}, {"force", {{3, {2.0}, 0}}, {}}));
  EXPECT_TRUE(errAlike({"force", {{1, {2.0}, 0}}, {}}, {"force", {{1, {2.0 + 1e-12}, 0}}, {}}));
}

TEST(UnnamedMistakes, OfWhatIsBuiltOnAWrongFunctionAreTheLowerOnes) {
  Verdict verdict;
  verdict.tests = {{"Fails", "", false, {}, ""}};
  verdict.evidence["force"].calls = verdict.evidence["force"].wrong = 5;
  verdict.evidence["acceleration"] = verdict.evidence["force"];
  GradedExercise exercise;
  exercise.manifest.criteria.push_back({"Both", "Both", 1.0, false, "", {"acceleration"}, {"force"}});
  exercise.verdicts["Both"] = verdict;
  ASSERT_EQ(unnamedMistakes(exercise).size(), 1U);
  EXPECT_EQ(unnamedMistakes(exercise)[0].function, "force");
}

}  // namespace
}  // namespace muelle::grader
