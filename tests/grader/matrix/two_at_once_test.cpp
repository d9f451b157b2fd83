/// \file
/// Two submissions graded at the same time in one build tree do not disturb each other, as `ctest --preset grade`
/// grades them.

#include "base/file.h"
#include "base/process/child.h"
#include "grader/matrix/expectation.h"
#include "grader/run/workplace.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <thread>

namespace {

using namespace muelle::grader;
namespace fs = std::filesystem;

constexpr int rounds = 5;

/// The first exercise of the course, a right and a wrong submission of it, and what the wrong one loses.
struct Pair {
  muelle::Manifest exercise;
  fs::path right;
  fs::path wrong;
  std::set<std::string> lost;
};

Pair pairOfFirstExercise() {
  const Workplace workplace = Workplace::ofThisBuild();
  Pair pair;
  pair.exercise = muelle::readCourse(workplace.exercises()).front();
  const fs::path corpus = workplace.source / "tests" / "submissions" / pair.exercise.topic;
  const auto first = [](const fs::path& folder) {
    std::set<fs::path> children;
    for (const auto& entry : fs::directory_iterator(folder)) children.insert(entry.path());
    return *children.begin();
  };
  pair.right = first(corpus / "right");
  pair.wrong = first(corpus / "wrong");
  const fs::path source = pair.wrong / pair.exercise.files.front();
  pair.lost = readExpectation(muelle::readFile(source), source.string(), pair.exercise).lost;
  return pair;
}

/// Runs CTest on one submission, the curves aside; the suites whose tests failed. Every round has other inputs, so that
/// nothing is found kept.
std::set<std::string> failedSuites(const Pair& pair, const fs::path& submission, int round) {
  const muelle::TemporaryFolder folder(fs::temp_directory_path());
  const fs::path report = folder.path() / "report.xml";
  const std::string& topic = pair.exercise.topic;
  muelle::ChildSpec spec;
  spec.command = {"/usr/bin/ctest",
                  "--test-dir",
                  Workplace::ofThisBuild().binary.string(),
                  "-L",
                  "^grade$",
                  "-L",
                  "^" + topic + "$",
                  "-E",
                  "curves",
                  "--output-junit",
                  report.string()};
  spec.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "MUELLE_SUBMISSION=" + submission.string(),
                      "MUELLE_SEED=two at once " + std::to_string(round)};
  muelle::Capture capture;
  capture.limit = std::chrono::minutes(2);
  const auto result = runCommand(spec, capture);
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file(report.c_str())) << result.out;
  std::set<std::string> failed;
  for (const pugi::xml_node test : document.child("testsuite").children("testcase")) {
    const std::string name = test.attribute("name").value();
    if (std::string(test.attribute("status").value()) != "run") failed.insert(name.substr(name.rfind('.') + 1));
  }
  return failed;
}

TEST(TwoAtOnce, GetTheSameVerdictsEveryTime) {
  const Pair pair = pairOfFirstExercise();
  ASSERT_FALSE(pair.lost.empty());
  for (int round = 0; round < rounds; ++round) {
    std::set<std::string> lost;
    std::thread other([&] { lost = failedSuites(pair, pair.wrong, round); });
    EXPECT_EQ(failedSuites(pair, pair.right, round), std::set<std::string>{}) << "round " << round;
    other.join();
    EXPECT_EQ(lost, pair.lost) << "round " << round;
  }
}

}  // namespace
