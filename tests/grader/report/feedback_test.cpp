#include "grader/report/explanation.h"
#include "sample.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

using Lines = std::vector<std::string>;

GradedExercise failing(FeedbackLevel level, bool named) {
  Verdict v = verdict("HookeForce", 1, 1);
  if (named) v.mistakes = {namedSign()};
  v.output = "k = 100\n";
  GradedExercise exercise = with(exerciseWithoutVerdicts(), v);
  exercise.manifest.feedback = level;
  return exercise;
}

Lines hookeFeedback(const GradedExercise& exercise) { return feedback(exercise.manifest.criteria[0], exercise); }

const std::string says =
    "Your force has the right size and the wrong sign: F_a points from a towards b when the spring is stretched.";
const std::string mend = "Check which node the unit vector starts at, with xa = 0, xb = 2 and L0 = 1.";
const std::string hint = "hint: look at the sign of the elongation L - L0";
const std::string law = "not yet: The force obeys law number 0.";
const std::string called = "springForce(0.5, 3.25, 100, 1)";
const std::string values = "  springForce: got -2.5, expected 2.5 (difference -5, tolerance 1e-12)";

TEST(Feedback, IsEmptyForAPassedCriterion) {
  EXPECT_EQ(hookeFeedback(with(exerciseWithoutVerdicts(), verdict("HookeForce", 2, 0))), Lines{});
}

TEST(Feedback, NamesTheMisconceptionFirst) {
  EXPECT_EQ(hookeFeedback(failing(FeedbackLevel::Values, true)), (Lines{says, mend, law, called, values}));
}

TEST(Feedback, EndsWithTheCriterionsHintWhenNoMistakeWasNamed) {
  EXPECT_EQ(hookeFeedback(failing(FeedbackLevel::Values, false)), (Lines{law, called, values, hint}));
}

TEST(Feedback, AtLevelPropertyTellsNoValues) {
  EXPECT_EQ(hookeFeedback(failing(FeedbackLevel::Property, true)), (Lines{says, mend, law}));
  EXPECT_EQ(hookeFeedback(failing(FeedbackLevel::Property, false)), (Lines{law, hint}));
}

TEST(Feedback, AtLevelCriterionTellsOnlyTheHint) {
  EXPECT_EQ(hookeFeedback(failing(FeedbackLevel::Criterion, true)), Lines{hint});
  GradedExercise exercise = failing(FeedbackLevel::Criterion, false);
  exercise.manifest.criteria[0].hint.clear();
  EXPECT_EQ(hookeFeedback(exercise), Lines{"failed"});
}

TEST(Feedback, PutsTheFaultBeforeTheProperty) {
  GradedExercise exercise = failing(FeedbackLevel::Property, false);
  exercise.verdicts.at("HookeForce").fault = "springForce ran for more than 2 s";
  EXPECT_EQ(hookeFeedback(exercise), (Lines{"springForce ran for more than 2 s", law, hint}));
}

TEST(Feedback, OfAFaultIsToldAtEveryLevel) {
  GradedExercise exercise = failing(FeedbackLevel::Criterion, false);
  exercise.verdicts.at("HookeForce").fault = "segmentation fault in springForce";
  EXPECT_EQ(hookeFeedback(exercise), (Lines{"segmentation fault in springForce", hint}));
}

TEST(Feedback, OfAFailedBuildIsOneLine) {
  using Status = BuildOutcome::Status;
  GradedExercise exercise = exerciseWithoutVerdicts();
  exercise.build = {Status::Missing, "", ""};
  EXPECT_EQ(hookeFeedback(exercise), Lines{"spring_1d.cpp was not handed in"});
  exercise.build = {Status::CompileError, "spring_1d.cpp:3: expected ';'", "many\nlines"};
  EXPECT_EQ(hookeFeedback(exercise), Lines{"spring_1d.cpp:3: expected ';'"});
  exercise.build = {Status::GraderFault, "no compiler", ""};
  EXPECT_EQ(hookeFeedback(exercise), Lines{"the grader failed, not you; no score, it will be run again: no compiler"});
}

TEST(Feedback, SaysThatACriterionHasNoRecord) {
  EXPECT_EQ(hookeFeedback(exerciseWithoutVerdicts()),
            Lines{"no record of this criterion: the grader failed, not you; run the same command again"});
}

TEST(Feedback, SaysWhenTheMachineEndedTheRun) {
  Verdict v = verdict("HookeForce", 1, 1);
  v.outcome = Outcome::Killed;
  EXPECT_EQ(hookeFeedback(with(exerciseWithoutVerdicts(), v)),
            Lines{"the grader failed, not you; no score, it will be run again: the run was killed from outside"});
}

TEST(Feedback, WhatASanitizerSaysOfMemoryNeverWrittenStandsForItself) {
  GradedExercise exercise = failing(FeedbackLevel::Values, false);
  Verdict& verdict = exercise.verdicts.at("HookeForce");
  verdict.outcome = Outcome::NeverWritten;
  verdict.isConfirmed = true;
  verdict.fault = "springForce reads a bool to which nothing was written at spring_1d.cpp:5";
  EXPECT_EQ(hookeFeedback(exercise).front(), verdict.fault);
}

TEST(Feedback, SaysWhatWasNeverWrittenBeforeAnyMistake) {
  for (const FeedbackLevel level : {FeedbackLevel::Values, FeedbackLevel::Property, FeedbackLevel::Criterion}) {
    GradedExercise exercise = failing(level, true);
    exercise.verdicts.at("HookeForce").outcome = Outcome::NeverWritten;
    EXPECT_TRUE(hookeFeedback(exercise).front().starts_with("it returned memory to which nothing was written"));
  }
}

TEST(Feedback, ShowsEveryCallOnce) {
  GradedExercise exercise = failing(FeedbackLevel::Values, true);
  auto& mismatches = exercise.verdicts.at("HookeForce").tests[1].mismatches;
  Mismatch other = mismatches.front();
  other.call = "springForce(7, 8, 9, 1)";
  other.label = "force on a";
  other.unit = "N";
  mismatches = {mismatches.front(), mismatches.front(), other};
  EXPECT_EQ(hookeFeedback(exercise),
            (Lines{says, mend, law, called, values, values, "springForce(7, 8, 9, 1)",
                   "  force on a: got -2.5 N, expected 2.5 N (difference -5, tolerance 1e-12)"}));
}

TEST(Feedback, ShowsTheFirstFewFailures) {
  GradedExercise exercise = failing(FeedbackLevel::Values, true);
  auto& mismatches = exercise.verdicts.at("HookeForce").tests[1].mismatches;
  mismatches.resize(6, mismatches.front());
  EXPECT_EQ(hookeFeedback(exercise),
            (Lines{says, mend, law, called, values, values, values, values, "  ... and 2 more"}));
}

TEST(Feedback, EndsWithHowTheFileWasTaken) {
  GradedExercise exercise = failing(FeedbackLevel::Property, false);
  exercise.note = "taken from spring_1d (1).cpp";
  EXPECT_EQ(hookeFeedback(exercise), (Lines{law, hint, "note: taken from spring_1d (1).cpp"}));
  exercise.build = {BuildOutcome::Status::Missing, "", ""};
  EXPECT_EQ(hookeFeedback(exercise), (Lines{"spring_1d.cpp was not handed in", "note: taken from spring_1d (1).cpp"}));
}

TEST(Feedback, TellsTheGradersFaultApart) {
  Verdict v = verdict("HookeForce", 0, 2);
  v.graderFault = "disk full";
  EXPECT_EQ(hookeFeedback(with(exerciseWithoutVerdicts(), v)),
            Lines{"the grader failed, not you; no score, it will be run again: disk full"});
}

TEST(Feedback, IsPrintable) {
  for (const std::string& text : hostileTexts()) {
    const GradedSubmission graded = hostileSubmission(text);
    for (const std::string& line : feedback(graded.exercises[0].manifest.criteria[0], graded.exercises[0])) {
      EXPECT_EQ(line.find_first_of(std::string("\0\n\r\x1b\x7f\x07", 6)), std::string::npos);
    }
  }
}

TEST(Feedback, ShowsWhatWasPrintedOnlyWithTheValues) {
  // A function can print its arguments: below that level the report would hand out the hidden inputs.
  const auto shown = [](FeedbackLevel level) {
    const GradedExercise exercise = failing(level, false);
    return shownOutput(exercise.manifest.criteria[0], exercise);
  };
  EXPECT_EQ(shown(FeedbackLevel::Values), "k = 100\n");
  EXPECT_EQ(shown(FeedbackLevel::Property), "");
  EXPECT_EQ(shown(FeedbackLevel::Criterion), "");
}

}  // namespace
}  // namespace muelle::grader
