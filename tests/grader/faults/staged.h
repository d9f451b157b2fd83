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
  GradedExercise grade(const Sources& sources) const;
  GradedExercise grade(const Sources& sources, std::unique_ptr<Sandbox> sandbox) const;

  /// No score for anything, and words of whose fault it is.
  static void expectNoScore(const GradedExercise& graded);
  /// The points of each criterion, as on a machine where all is well.
  void expectUndisturbed(const GradedExercise& graded, const Sources& sources) const;

  /// A shell script in the place of the compiler; `$compiler` in it is the real one.
  void putInCompilersPlace(const std::string& script);
  void putCompilerBack();

  const Sources& honest() const { return honest_; }
  const Sources& wrong() const { return wrong_; }

  TemporaryFolder folder_{std::filesystem::temp_directory_path()};
  Workplace workplace_ = Workplace::ofThisBuild();
  Manifest exercise_;

 private:
  Sources honest_;
  Sources wrong_;
};

}  // namespace muelle::grader
