/// \file
/// Two submissions graded at the same time in one build tree do not disturb each other.

#include "base/process/child.h"
#include "grader/run/grade.h"

#include <gtest/gtest.h>
#include <chrono>
#include <set>
#include <thread>

namespace {

using namespace muelle::grader;

constexpr int rounds = 20;
constexpr const char* topic = "spring_1d";
constexpr const char* usualSeed = "two at once";

GradingJob jobFor(const std::string& submission) {
  const Workplace workplace = Workplace::ofThisBuild();
  GradeOptions options;
  options.seed = usualSeed;
  options.sandbox = makeSandbox(SandboxChoice::Automatic)->choice();
  return openJob(workplace, workplace.source / "tests" / "submissions" / topic / submission, options);
}

/// What `ctest --preset grade` does, for the one exercise that the submission has; the curves are no part of the score.
std::string runCtest(const GradingJob& job) {
  muelle::ChildSpec spec;
  spec.command = {"/usr/bin/ctest", "--test-dir", job.workplace.binary.string(),  "-L",
                  "^grade$",        "-L",         std::string("^") + topic + "$", "-E",
                  "curves"};
  spec.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "MUELLE_SUBMISSION=" + job.submission.path.string(),
                      "MUELLE_SEED=" + job.options.seed, "MUELLE_SANDBOX=" + toText(job.options.sandbox)};
  muelle::Capture capture;
  capture.limit = std::chrono::minutes(2);
  return runCommand(spec, capture).out;  // shown when the records are not as they should be
}

/// What went wrong on our side, a line each.
std::string graderFaults(const GradedSubmission& graded) {
  std::string faults;
  for (const GradedExercise& exercise : graded.exercises) {
    if (exercise.build.status == BuildOutcome::Status::GraderFault) faults += "build: " + exercise.build.message + "\n";
    for (const auto& [suite, verdict] : exercise.verdicts) {
      if (!verdict.graderFault.empty()) faults += suite + ": " + verdict.graderFault + "\n";
    }
  }
  return faults;
}

std::set<std::string> lostSuites(const GradedSubmission& graded) {
  std::set<std::string> lost;
  for (const GradedExercise& exercise : graded.exercises) {
    if (exercise.manifest.topic != topic) continue;
    for (const muelle::Criterion& criterion : exercise.manifest.criteria) {
      const auto verdict = exercise.verdicts.find(criterion.suite);
      if (verdict == exercise.verdicts.end() || !verdict->second.passed()) lost.insert(criterion.suite);
    }
  }
  return lost;
}

TEST(TwoAtOnce, GetTheSameScoresEveryTime) {
  const GradingJob right = jobFor("right/by_cases");
  const GradingJob wrong = jobFor("wrong/same_force_on_both");
  const double full = muelle::findExercise(right.course, topic).points;
  for (int round = 0; round < rounds; ++round) {
    forget(right);
    forget(wrong);
    std::string wrongLog;
    std::thread other([&] { wrongLog = runCtest(wrong); });
    const std::string rightLog = runCtest(right);
    other.join();
    const GradedSubmission rightGrade = collect(right);
    const GradedSubmission wrongGrade = collect(wrong);
    ASSERT_EQ(graderFaults(rightGrade), "") << "round " << round << rightLog;
    ASSERT_EQ(graderFaults(wrongGrade), "") << "round " << round << wrongLog;
    ASSERT_DOUBLE_EQ(score(rightGrade), full) << "round " << round;
    ASSERT_EQ(lostSuites(rightGrade), std::set<std::string>{}) << "round " << round;
    ASSERT_EQ(lostSuites(wrongGrade), (std::set<std::string>{"ShortSpring", "ThirdLaw", "ZeroLength"}))
        << "round " << round;
  }
}

}  // namespace
