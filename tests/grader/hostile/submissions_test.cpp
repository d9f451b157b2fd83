/// \file
/// Folders of tests/submissions/hostile (a share of the known ones, see corpus_share.h) are graded through the real
/// path. The first line of its source says
/// "// attack: what it does; expect: zero points[; says: regular expression of the feedback]".

#include "grading.h"
#include "surroundings.h"

#include "base/build_paths.h"
#include "grader/built_exercises.h"
#include "grader/matrix/corpus_share.h"
#include "support/manifest_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

fs::path corpus() { return fs::path(build_paths::source) / "tests" / "submissions" / "hostile"; }

std::vector<std::string> attacks() {
  const CorpusShare share(corpus().parent_path(), shareOfEnvironment());
  const BuiltExercises built(Workplace::ofThisBuild());
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(corpus())) {
    if (share.takes(entry.path()) && built.haveOneOf(entry.path())) names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Reads the first line. Throws std::runtime_error when it is not as it should be.
std::string expectedWords(const fs::path& source) {
  std::ifstream stream(source);
  std::string line;
  std::getline(stream, line);
  static const std::regex form("// attack: [^;]+; expect: zero points(; says: (.+))?");
  std::smatch match;
  if (!std::regex_match(line, match, form)) throw std::runtime_error(source.string() + ": the first line is malformed");
  return match[2];
}

class Hostile : public ::testing::TestWithParam<std::string> {};

TEST_P(Hostile, GetsNoPointsAndChangesNothing) {
  const fs::path folder = corpus() / GetParam();
  const std::string topic = manifestOf(folder, Workplace::ofThisBuild().exercises()).topic;
  const std::string says = expectedWords(folder / (topic + ".cpp"));
  const Surroundings surroundings(folder);
  const GradedSubmission graded = gradeAttack(folder, topic);
  if (graded.exercises.front().build.outcome == Outcome::Forbidden) {
    // Refused by what it uses before it ran. A system call needs no symbol: the sandbox must hold without that, too.
    expectDefeated(graded, "");
    expectDefeated(gradeAttack(folder, topic, false), says);
  } else {
    expectDefeated(graded, says);
  }
  EXPECT_EQ(surroundings.changes(), "");
}

INSTANTIATE_TEST_SUITE_P(Submission, Hostile, ::testing::ValuesIn(attacks()),
                         [](const auto& attack) { return attack.param; });

}  // namespace
}  // namespace muelle::grader
