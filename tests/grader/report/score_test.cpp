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

TEST(Score, IsNoneWithoutARecordInABuiltExercise) {
  GradedSubmission graded;
  graded.exercises = {with(exerciseWithoutVerdicts(), verdict("HookeForce", 3, 0))};
  EXPECT_EQ(acceleration(graded.exercises[0]), std::nullopt);
  EXPECT_EQ(hooke(graded.exercises[0]), 4.0);
  EXPECT_TRUE(hasGraderFault(graded));
  EXPECT_TRUE(hasGraderFault(graded.exercises[0]));
}

TEST(Score, IsNoneForARecordWithoutTests) {
  EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), verdict("HookeForce", 0, 0))), std::nullopt);
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), verdict("Acceleration", 0, 0))), std::nullopt);
}

TEST(Score, IsNothingWhenNoTestCouldRunForTheStudentsFault) {
  Verdict v = verdict("HookeForce", 0, 0);
  v.fault = "the code that runs when your file is loaded does not end";
  v.outcome = Outcome::Cpu;
  EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), v)), 0.0);
}

TEST(Score, IsNoneForARunThatTheMachineEnded) {
  for (const Outcome outcome : {Outcome::Killed, Outcome::Wall}) {
    for (const char* fault : {"", "springForce was killed"}) {
      for (const int failed : {0, 1}) {
        Verdict v = verdict("HookeForce", 3, failed);
        v.outcome = outcome;
        v.fault = fault;
        EXPECT_EQ(hooke(with(exerciseWithoutVerdicts(), v)), std::nullopt) << nameOf(outcome) << fault << failed;
      }
    }
  }
}

TEST(Score, IsNothingForWhatTheStudentsCodeDid) {
  for (const Outcome outcome : {Outcome::Forbidden, Outcome::Crash, Outcome::Cpu, Outcome::NeverWritten}) {
    for (const char* suite : {"HookeForce", "Acceleration"}) {
      Verdict v = verdict(suite, 3, 0);
      v.outcome = outcome;
      EXPECT_EQ(score(with(exerciseWithoutVerdicts(), v).manifest.criteria[suite[0] == 'H' ? 0 : 1],
                      with(exerciseWithoutVerdicts(), v)),
                0.0)
          << nameOf(outcome);
    }
  }
}

TEST(Score, ARecordThatContradictsItselfIsNoEvidence) {
  Verdict v = verdict("Acceleration", 3, 0);
  v.outcome = Outcome::Wrong;
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), v)), std::nullopt);
  v = verdict("Acceleration", 2, 1);
  v.outcome = Outcome::Passed;
  EXPECT_FALSE(v.passed());
  EXPECT_EQ(acceleration(with(exerciseWithoutVerdicts(), v)), std::nullopt);
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
  EXPECT_EQ(hooke(exercise), std::nullopt);
  exercise.verdicts["HookeForce"] = verdict("HookeForce", 5, 0);
  exercise.verdicts["HookeForce"].topic = "triangle";
  EXPECT_EQ(hooke(exercise), std::nullopt);
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
  GradedExercise exercise = with(exerciseWithoutVerdicts(), verdict("MyOwnCriterion", 9, 0));
  EXPECT_EQ(score(exercise), 0.0);
  EXPECT_TRUE(hasGraderFault(exercise)) << "its own criteria have no record";
}

}  // namespace
}  // namespace muelle::grader
