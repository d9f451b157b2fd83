#pragma once
#include "course/check/student_program.h"
#include "course/check/test_report.h"
#include "course/manifest.h"

#include <string>
#include <vector>

namespace muelle {

/// The class to which a check belongs, as `grade` would sort it on the same inputs: that of the build when it failed.
Outcome checkOutcome(const StudentProgram& program, const TestReport& report);

/// Runs the public tests of a built program, what follows a test that ends it in a process of its own; and of its
/// sanitised build, when there is one, of which only what it confirms counts, in the tests that show it. Throws
/// std::runtime_error when the machine is too busy for a verdict.
TestReport runPublicTests(const StudentProgram& program);

/// What the demo left.
struct CurvesReport {
  std::vector<std::filesystem::path> figures;
  std::string trouble;  ///< why there are none, or not all; "" when all is well
};

/// The mistakes that the numbers of the public tests show as they are: those of the manifest in its order and words,
/// then what no manifest need list. None when memory was never written or the program crashed: then numbers are luck.
std::vector<Misconception> namedMistakes(const TestReport& report, const Manifest& manifest);

/// Runs the demo of a built program and draws its curves into `folder`, in the place of those that the check before has
/// drawn there. \param remark behind the title of the first
/// figure; "" for none
CurvesReport drawCurves(const StudentProgram& program, const std::filesystem::path& folder, const std::string& remark);

}  // namespace muelle
