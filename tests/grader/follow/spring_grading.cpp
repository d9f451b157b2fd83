#include "spring_grading.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

Grader springGrader(const fs::path& kept) {
  Workplace workplace = Workplace::ofThisBuild();
  workplace.kept = kept;
  const char* name = std::getenv("MUELLE_SANDBOX");
  GradeOptions options;
  options.sandbox = parseSandboxChoice(name != nullptr ? name : "");
  options.seed = "a seed of these tests";
  options.withCurves = false;
  return openGrader(workplace, options, {"spring_1d"});
}

}  // namespace

SpringGrading::SpringGrading() : kept_(fs::temp_directory_path()), grader_(springGrader(kept_.path() / "kept")) {}

GradedExercise SpringGrading::grade(const std::string& source) {
  const fs::path file = kept_.path() / "spring_1d.cpp";
  writeFile(file, source);
  GradedExercise graded = muelle::grader::grade(grader_, grader_.take(file), 2).exercises.front();
  for (const Criterion& criterion : graded.manifest.criteria) {
    EXPECT_EQ(graderFault(criterion, graded), "") << criterion.suite;
  }
  return graded;
}

std::string SpringGrading::lost(const GradedExercise& graded) {
  std::string names;
  for (const Criterion& criterion : graded.manifest.criteria) {
    if (score(criterion, graded).value_or(0.0) == criterion.points) continue;
    names += (names.empty() ? "" : " ") + criterion.suite;
  }
  return names;
}

std::vector<std::string> SpringGrading::followed(const GradedExercise& graded, const std::string& suite) {
  const auto verdict = graded.verdicts.find(suite);
  return verdict == graded.verdicts.end() ? std::vector<std::string>() : verdict->second.followed;
}

int SpringGrading::startedSince() {
  const int before = std::exchange(started_, grader_.started());
  return started_ - before;
}

}  // namespace muelle::grader
