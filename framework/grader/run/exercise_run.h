#pragma once
#include "grader/run/grade.h"

#include <map>
#include <memory>
#include <mutex>

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

  /// The verdict that needs no test: a kept one, or that of a function that is known not to return.
  std::optional<Verdict> known(const Criterion& criterion, Try attempt);
  void settle(const Criterion& criterion, Verdict verdict);
  void finishPart();
  void fail(const std::string& what);

  /// A function of the criterion that has run out of time elsewhere: the suite in which it did, "" when there is none.
  std::string timedOutIn(const std::map<std::string, std::string>& suites, const Criterion& criterion,
                         std::string& function) const;
  Verdict withoutTrying(const Criterion& criterion, const std::string& function, const std::string& suite) const;

  Grader& grader_;
  Pool& pool_;
  const Manifest& manifest_;
  Sources sources_;
  std::unique_ptr<Candidate> candidate_;
  std::function<void(GradedExercise)> done_;

  std::mutex mutex_;
  GradedExercise graded_;
  std::size_t missing_ = 0;                       ///< criteria and curves that are not done
  std::map<std::string, std::string> suspected_;  ///< function -> suite in which it ran out of time once
  std::map<std::string, std::string> confirmed_;  ///< ... and once more, alone
};

}  // namespace muelle::grader
