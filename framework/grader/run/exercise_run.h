#pragma once
#include "grader/run/grade.h"

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

namespace muelle::grader {

/// The grading of one hand-in of one exercise, as tasks of a pool: build, then the criteria and the curves side by
/// side.
class ExerciseRun : public std::enable_shared_from_this<ExerciseRun> {
 public:
  ExerciseRun(Grader& grader, Pool& pool, const Manifest& manifest, std::function<void(GradedExercise)> done);

  /// Tasks of the pool: the first builds and adds the others, the second has nothing to grade.
  void begin(Sources sources);
  void leaveOut(const BuildOutcome& why);

 private:
  /// Whether nothing else runs: then what is seen is believed.
  enum class Try { Shared, Alone };

  void build(Try attempt);
  void judge(std::size_t criterion, Try attempt);
  void draw();
  /// The kept ones, or new ones.
  Curves curves();

  /// The verdict that needs no test: a kept one, or that of a file that does not end loading.
  std::optional<Verdict> known(const Criterion& criterion);
  Verdict asLoadingEnded(const Criterion& criterion) const;
  bool isExpected(const Verdict& verdict);
  void settle(const Criterion& criterion, Verdict verdict);
  void finishPart();
  void fail(const std::string& what);

  Grader& grader_;
  Pool& pool_;
  const Manifest& manifest_;
  Sources sources_;
  std::unique_ptr<Candidate> candidate_;
  std::function<void(GradedExercise)> done_;

  std::mutex mutex_;
  GradedExercise graded_;
  std::size_t missing_ = 0;           ///< criteria and curves that are not done
  std::optional<Verdict> loading_;    ///< of a file that does not end loading
  std::set<std::string> unreturned_;  ///< functions that did not return, though nothing else ran, or wait for ever
};

}  // namespace muelle::grader
