#pragma once
#include "grader/intake/intake.h"
#include "grader/run/run_criterion.h"

#include <functional>

namespace muelle::grader {

/// The submission that a grading run is about, its course, and how it is graded.
struct GradingJob {
  Workplace workplace;
  std::vector<Manifest> course;
  Submission submission;
  GradeOptions options;

  /// Sources of one exercise, or null when they are missing or refused.
  const Sources* sources(const Manifest& manifest) const;
};

/// Reads course and submission. Throws std::runtime_error when there is nothing to grade.
GradingJob openJob(const Workplace& workplace, const std::filesystem::path& submission, GradeOptions options);

/// The instructor's seed kept in the build folder; made at random on first use.
std::string keptSeed(const Workplace& workplace);

/// What ctest shows as its environment: MUELLE_SUBMISSION, MUELLE_SEED, MUELLE_SANDBOX -> a job.
/// Throws std::runtime_error when MUELLE_SUBMISSION is not set.
GradingJob jobFromEnvironment(const Workplace& workplace);

/// Is everything of this job kept already?
bool isComplete(const GradingJob& job);

/// Removes what is kept of this job, workers included.
void forget(const GradingJob& job);

/// Called as the tests of the run finish.
using ProgressListener = std::function<void(int done, int all)>;

/// Grades through CTest, one test per criterion, `jobs` at a time, then collects the records.
GradedSubmission grade(const GradingJob& job, int jobs, const ProgressListener& progress = {});

/// What the records say, without running anything.
GradedSubmission collect(const GradingJob& job);

/// Builds and grades one exercise in this process's children, without CTest: for the tests of the tests.
GradedExercise gradeExercise(const GradingJob& job, const Manifest& manifest, const Sandbox& sandbox, bool withCurves);

/// The file that CTest includes: one test per criterion, a fixture per exercise that builds its worker, labels
/// `grade` and the topic.
std::string ctestFile(const Workplace& workplace, const std::vector<Manifest>& course);

}  // namespace muelle::grader
