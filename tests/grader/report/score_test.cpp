#include "grader/verdict.h"
#include "sample.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

std::optional<double> hooke(const GradedExercise& exercise) { return score(exercise.manifest.criteria[0], exercise); }
std::optional<double> acceleration(const GradedExercise& exercise) {
  return score(exercise.manifest.criteria[1], exercise);
}

TEST(Score, IsTheManifestsPointsWhenEveryTestPassed) {
  EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), verdict("HookeForce", 3, 0))), 4.0);
}

TEST(Score, IsNothingWithoutARecord) {
  EXPECT_EQ(hooke(exerciseWithoutVerdicts()), 0.0);
  EXPECT_EQ(acceleration(exerciseWithoutVerdicts()), 0.0);
}

TEST(Score, IsNothingForARecordWithoutTests) {
  EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), verdict("HookeForce", 0, 0))), 0.0);
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), verdict("Acceleration", 0, 0))), 0.0);
}

TEST(Score, IsAllOrNothingUnlessPartial) {
  EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), verdict("HookeForce", 3, 1))), 0.0);
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), verdict("Acceleration", 2, 1))), 2.0);
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), verdict("Acceleration", 0, 3))), 0.0);
}

TEST(Score, AFaultOfTheStudentsCodeCostsTheCriterionWhole) {
  for (const char* suite : {"HookeForce", "Acceleration"}) {
    Verdict v = verdict(suite, 5, 0);
    v.fault = "exit(0) in springForce";
    EXPECT_EQ(score(with(exerciseWithoutVerdicts(), v)), 0.0) << suite;
    EXPECT_FALSE(v.passed());
  }
}

TEST(Score, AFaultOfTheGraderIsNoScore) {
  Verdict v = verdict("HookeForce", 5, 0);
  v.graderFault = "disk full";
  const GradedExercise exercise = with(with(exerciseWithoutVerdicts(), v), verdict("Acceleration", 3, 0));
  EXPECT_EQ(hooke(exercise), std::nullopt);
  EXPECT_EQ(score(exercise), 3.0);
  GradedSubmission graded;
  graded.exercises = {exercise};
  EXPECT_TRUE(hasGraderFault(graded));
  EXPECT_EQ(score(graded), 3.0);
}

TEST(Score, ARecordCountsOnlyForItsOwnCriterion) {
  GradedExercise exercise = exerciseWithoutVerdicts();
  exercise.verdicts["HookeForce"] = verdict("Acceleration", 5, 0);
  EXPECT_EQ(hooke(exercise), 0.0);
  exercise.verdicts["HookeForce"] = verdict("HookeForce", 5, 0);
  exercise.verdicts["HookeForce"].topic = "triangle";
  EXPECT_EQ(hooke(exercise), 0.0);
}

TEST(Score, IsNothingWhenTheFileWasNotBuilt) {
  using Status = BuildOutcome::Status;
  for (const Status status : {Status::Missing, Status::Refused, Status::CompileError}) {
    GradedExercise exercise = with(exerciseWithoutVerdicts(), verdict("HookeForce", 5, 0));
    exercise.build.status = status;
    EXPECT_EQ(hooke(exercise), 0.0);
  }
  GradedExercise exercise = with(exerciseWithoutVerdicts(), verdict("HookeForce", 5, 0));
  exercise.build.status = Status::GraderFault;
  EXPECT_EQ(hooke(exercise), std::nullopt);
  EXPECT_EQ(score(exercise), 0.0);
}

TEST(Score, SumsOverCriteriaAndExercises) {
  const GradedSubmission graded = sampleSubmission();
  EXPECT_EQ(score(graded), 7.0 + 2.0 + 0.0 + 0.0 + 0.0);
  EXPECT_EQ(maxScore(graded), 5 * 7.0);
  EXPECT_FALSE(hasGraderFault(graded));
}

TEST(Score, AnUnknownSuiteEarnsNothing) {
  EXPECT_EQ(score(with(exerciseWithoutVerdicts(), verdict("MyOwnCriterion", 9, 0))), 0.0);
}

}  // namespace
}  // namespace muelle::grader
