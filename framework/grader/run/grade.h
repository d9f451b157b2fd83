#pragma once
#include "grader/intake/intake.h"
#include "grader/run/judge.h"
#include "grader/run/pool.h"

#include <atomic>
#include <functional>
#include <memory>

namespace muelle::grader {

/// The grading engine: course, sandbox and store are opened once; submissions are graded as tasks of one pool.
///
/// Nothing here throws for one submission: what goes wrong on our side becomes a fault of the grader in that
/// submission, and the others are graded.
class Grader {
 public:
  /// \param course what is graded   \param wholeCourse what a hand-in may hold besides; empty: the same
  /// \param sandbox settled: options.sandbox is set to its choice
  Grader(Workplace workplace, std::vector<Manifest> course, GradeOptions options, std::unique_ptr<Sandbox> sandbox,
         std::vector<Manifest> wholeCourse = {});

  const Workplace& workplace() const { return workplace_; }
  /// The exercises that are graded, and all that there are.
  const std::vector<Manifest>& course() const { return course_; }
  const std::vector<Manifest>& wholeCourse() const { return wholeCourse_; }
  const GradeOptions& options() const { return options_; }
  const Sandbox& sandbox() const { return *sandbox_; }
  JudgingPlace judgingPlace() const { return {workplace_, objects_, records_, *sandbox_}; }
  const Store& objects() const { return objects_; }
  const Store& records() const { return records_; }

  /// Reads a hand-in, once: what is saved there afterwards changes nothing. Throws as takeSubmission() does.
  Submission take(const std::filesystem::path& path) const;
  Submission take(const std::vector<std::filesystem::path>& parts) const;

  /// Adds the grading of a submission to the pool. `done` is called once, in a task of the pool, with the result.
  void add(Pool& pool, const Submission& submission, std::function<void(GradedSubmission)> done);

  /// The same for one exercise.
  /// \param sources null: there is nothing to build, and `otherwise` says why
  void addExercise(Pool& pool, const Manifest& manifest, const Sources* sources, const BuildOutcome& otherwise,
                   std::function<void(GradedExercise)> done);

  /// Tasks that have ended and tasks that are known, for a progress bar.
  int finished() const { return finished_; }
  int known() const { return known_; }
  /// Called in a task whenever one of the two has changed.
  void onProgress(std::function<void()> listener) { listener_ = std::move(listener); }

  /// Programs that this grader has started: compilers, tests, drawings. An unchanged regrade starts none.
  int started() const { return started_; }

  /// Keeps the store below its bound, and removes what killed runs have left beside it.
  void prune() const;

 private:
  friend class ExerciseRun;
  void count(std::atomic<int>& counter, int by = 1);

  Workplace workplace_;
  std::vector<Manifest> course_;
  std::vector<Manifest> wholeCourse_;
  SourcesByTopic stubs_;
  GradeOptions options_;
  std::unique_ptr<Sandbox> sandbox_;
  Store objects_;
  Store records_;
  std::atomic<int> finished_{0};
  std::atomic<int> known_{0};
  std::atomic<int> started_{0};
  std::function<void()> listener_;
};

/// Opens the course of this checkout and the best sandbox that the options allow. Exercises whose test program is not
/// built are left out. Throws std::runtime_error when there is nothing to grade with.
Grader openGrader(const Workplace& workplace, GradeOptions options, const std::vector<std::string>& only = {});

/// Grades one submission with so many tasks at a time.
GradedSubmission grade(Grader& grader, const Submission& submission, int jobs);

}  // namespace muelle::grader
