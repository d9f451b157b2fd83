#pragma once
#include "base/file.h"
#include "grader/run/grade.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace muelle::grader {

/// A grading on a machine where something breaks, with an honest and a wrong submission of the course's first exercise,
/// and nothing kept from elsewhere.
class StagedFault : public ::testing::Test {
 protected:
  StagedFault();

  /// Grades once, as a command of its own would: what earlier ones have kept is found.
  GradedExercise grade(const Sources& sources, SandboxChoice sandbox = SandboxChoice::Automatic,
                       bool withCurves = false);
  GradedExercise grade(const Sources& sources, int jobs);
  GradedExercise grade(const Sources& sources, std::unique_ptr<Sandbox> sandbox, SandboxChoice choice,
                       bool withCurves = false, int jobs = 2);
  /// Programs that the last grading has started.
  int started() const { return started_; }

  /// No score for anything, and words of whose fault it is.
  static void expectNoScore(const GradedExercise& graded);
  /// Of each criterion no score, or the one of a machine where all is well.
  void expectNothingWrong(const GradedExercise& graded, const Sources& sources) const;
  /// The points of each criterion, as on a machine where all is well.
  void expectUndisturbed(const GradedExercise& graded, const Sources& sources) const;

  /// A shell script in the place of the compiler; `$compiler` in it is the real one.
  void putInCompilersPlace(const std::string& script);
  void putCompilerBack();

  void takeAllCriteria() { exercise_ = whole_; }

  const Sources& honest() const { return honest_; }
  const Sources& wrong() const { return wrong_; }

  TemporaryFolder folder_{std::filesystem::temp_directory_path()};
  Workplace workplace_ = Workplace::ofThisBuild();
  const Manifest whole_;  ///< the exercise with all its criteria
  Manifest exercise_;     ///< with some of them

 private:
  /// Suite -> points, of a grading that nothing disturbs.
  std::map<std::string, double> calmPoints(const Sources& sources) const;

  Sources honest_;
  Sources wrong_;
  int started_ = 0;
};

}  // namespace muelle::grader
