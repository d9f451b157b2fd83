#include "grader/authors/grade_again.h"

#include "base/file.h"
#include "spring_grading.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

/// A right spring_1d.cpp but for the acceleration of a hanging node.
std::string withHanging(const std::string& body) {
  using namespace spring_parts;
  return begin + mass + forceOnA + forceOnB +
         "double hangingAcceleration(double x, double m, const Attachment& top, double g) {\n" + body + "}\n" + between;
}

TEST(GradeAgain, GroupsHandInsThatErrAlike) {
  const TemporaryFolder kept(fs::temp_directory_path());
  Workplace workplace = Workplace::ofThisBuild();
  workplace.kept = kept.path() / "kept";
  const char* name = std::getenv("MUELLE_SANDBOX");
  GradeOptions options;
  options.sandbox = parseSandboxChoice(name != nullptr ? name : "");
  options.seed = "a seed of these tests";
  const Manifest manifest = findExercise(readCourse(workplace.exercises()), "spring_1d");
  const auto handIn = [&manifest](const std::string& student, const std::string& body) {
    return UnnamedHandIn{student, manifest, {{"spring_1d.cpp", withHanging(body)}}};
  };
  const std::vector<UnnamedGroup> groups = gradeAgain(
      workplace, options,
      {handIn("other", "  return springForceOnA(x, top.x, top.k, top.L0) / (m + 2) - g;\n"),
       handIn("named", "  return springForceOnA(x, top.x, top.k, top.L0) / m + g;\n"),
       handIn("one", "  return springForceOnA(x, top.x, top.k, top.L0) / (m + 1) - g;\n"),
       handIn("two",
              "  const double f = springForceOnA(x, top.x, top.k, top.L0);\n  return -(g + m * g - f) / (1 + m);\n")},
      2);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].handIns, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(groups[1].handIns, std::vector<std::string>{"other"});
  EXPECT_EQ(groups[0].mistake.function, "hangingAcceleration");
  ASSERT_TRUE(groups[0].mistake.example) << "a call that shows it";
}

}  // namespace
}  // namespace muelle::grader
