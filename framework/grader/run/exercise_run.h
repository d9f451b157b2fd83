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
  /// The kept ones, or new ones.
  Curves curves();

  /// The verdict that needs no test: a kept one, or that of a function that is known not to return.
  std::optional<Verdict> known(const Criterion& criterion, Try attempt);
  void settle(const Criterion& criterion, Verdict verdict);
  void finishPart();
  void fail(const std::string& what);

  /// Verdicts of other criteria, by the function that did not return in them.
  using Unreturned = std::map<std::string, Verdict>;
  /// The one among them that the criterion cannot do without; null when there is none.
  static const Verdict* unreturnedIn(const Unreturned& verdicts, const Criterion& criterion);
  Verdict withoutTrying(const Criterion& criterion, const Verdict& elsewhere) const;

  Grader& grader_;
  Pool& pool_;
  const Manifest& manifest_;
  Sources sources_;
  std::unique_ptr<Candidate> candidate_;
  std::function<void(GradedExercise)> done_;

  std::mutex mutex_;
  GradedExercise graded_;
  std::size_t missing_ = 0;  ///< criteria and curves that are not done
  Unreturned suspected_;     ///< did not return once
  Unreturned confirmed_;     ///< ... and once more, alone, or waits for what never comes
};

}  // namespace muelle::grader
