#pragma once
#include "base/file.h"
#include "grader/run/grade.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace muelle::grader {

/// Grades texts of spring_1d.cpp as `muelle grade` does, with the sandbox of MUELLE_SANDBOX or the strongest that
/// works. What one test keeps is thrown away after it.
class SpringGrading : public ::testing::Test {
 protected:
  SpringGrading();

  GradedExercise grade(const std::string& source);

  /// Names of the criteria that were not earned, in the manifest's order, separated by blanks.
  static std::string lost(const GradedExercise& graded);
  /// The lower functions by which the criterion was earned.
  static std::vector<std::string> followed(const GradedExercise& graded, const std::string& suite);
  /// Programs that have been started since the last call.
  int startedSince();

 private:
  TemporaryFolder kept_;
  Grader grader_;
  int started_ = 0;
};

/// The parts of a right spring_1d.cpp, to be put together with a wrong one.
namespace spring_parts {
inline const std::string begin = "#include \"spring_1d.h\"\n";
inline const std::string mass = "double lumpedMass(double M, int n) { return M / n; }\n";
inline const std::string forceOnA =
    "double springForceOnA(double xa, double xb, double k, double L0) {\n"
    "  const double L = std::abs(xa - xb);\n"
    "  if (L == 0) return 0;\n"
    "  return -k * (L - L0) * (xa - xb) / L;\n"
    "}\n";
inline const std::string forceOnB =
    "double springForceOnB(double xa, double xb, double k, double L0) { return -springForceOnA(xa, xb, k, L0); }\n";
inline const std::string hanging =
    "double hangingAcceleration(double x, double m, const Attachment& top, double g) {\n"
    "  return springForceOnA(x, top.x, top.k, top.L0) / m - g;\n"
    "}\n";
inline const std::string between =
    "double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {\n"
    "  const double f = springForceOnA(x, lower.x, lower.k, lower.L0) + springForceOnA(x, upper.x, upper.k, "
    "upper.L0);\n"
    "  return f / m - g;\n"
    "}\n";
inline const std::string above = forceOnB + hanging + between;
}  // namespace spring_parts

}  // namespace muelle::grader
