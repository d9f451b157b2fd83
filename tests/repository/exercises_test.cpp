/// \file
/// What every exercise must have. The exercises are found by their folders; a failure says which file is missing or
/// which two lists differ, so that it reads as a to-do list for the author.

#include "base/process/child.h"
#include "course/manifest.h"
#include "course/suites.h"
#include "folders.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using muelle::Manifest;

std::string contentOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// "suite NAME" and "mistake FUNCTION ID" lines of a hidden test program.
std::set<std::string> listing(const std::string& topic, const std::string& kind) {
  muelle::ChildSpec program;
  program.command = {(binary / "hidden" / ("hidden_" + topic)).string(), "--list"};
  std::istringstream lines(muelle::runCommand(program, {}).out);
  std::set<std::string> names;
  for (std::string first, rest; lines >> first && std::getline(lines >> std::ws, rest);) {
    if (first == kind) names.insert(rest);
  }
  return names;
}

class EveryExercise : public ::testing::Test {
 protected:
  const std::vector<Manifest> course = muelle::readCourse(source / "exercises");
};

TEST_F(EveryExercise, IsThereAtAll) { EXPECT_GE(course.size(), 6U); }

TEST_F(EveryExercise, HasAllItsFiles) {
  for (const Manifest& exercise : course) {
    const std::string& topic = exercise.topic;
    const std::vector<fs::path> needed = {
        fs::path("exercises") / topic / "README.md",       fs::path("exercises") / topic / "figure.svg",
        fs::path("exercises") / topic / (topic + ".h"),    fs::path("exercises") / topic / (topic + ".cpp"),
        fs::path("exercises") / topic / "public_test.cpp", fs::path("exercises") / topic / "demo.cpp",
        fs::path("solutions") / topic / (topic + ".cpp"),  fs::path("tests/hidden") / topic / (topic + "_test.cpp"),
        fs::path("tests/hidden") / topic / "oracle.cpp",   fs::path("tests/hidden") / topic / "mistakes.cpp",
        fs::path("tests/submissions") / topic / "right",   fs::path("tests/submissions") / topic / "wrong"};
    for (const fs::path& file : needed) EXPECT_TRUE(fs::exists(source / file)) << "missing: " << file.string();
  }
}

TEST_F(EveryExercise, HasNoFolderWithoutAManifest) {
  for (const char* room : {"exercises", "solutions", "tests/hidden"}) {
    for (const auto& entry : fs::directory_iterator(source / room)) {
      if (!entry.is_directory()) continue;
      const fs::path manifest = source / "exercises" / entry.path().filename() / "exercise.toml";
      EXPECT_TRUE(fs::exists(manifest)) << entry.path().string() << " belongs to no exercise";
    }
  }
}

// That suites and criteria are the same is the build's to say (agreement_TOPIC).
// One for each function's values, and the laws and edges beside them: an exercise of nine functions has thirteen.
TEST_F(EveryExercise, HasFiveToFifteenCriteria) {
  for (const Manifest& exercise : course) {
    EXPECT_GE(exercise.criteria.size(), 5U) << exercise.topic;
    EXPECT_LE(exercise.criteria.size(), 15U) << exercise.topic;
  }
}

TEST_F(EveryExercise, StatesEachMisconceptionThatItsTestsKnow) {
  // One mistake may show in several functions; the manifest names the most telling one.
  for (const Manifest& exercise : course) {
    const std::set<std::string> known = listing(exercise.topic, "mistake");
    std::set<std::string> knownIds;
    for (const std::string& entry : known) knownIds.insert(entry.substr(entry.find(' ') + 1));
    std::set<std::string> statedIds;
    for (const muelle::Misconception& misconception : exercise.misconceptions) {
      statedIds.insert(misconception.id);
      EXPECT_TRUE(known.contains(misconception.function + " " + misconception.id))
          << exercise.topic << ": mistakes.cpp has no " << misconception.id << " of " << misconception.function;
    }
    EXPECT_EQ(knownIds, statedIds) << "mistakes.cpp of " << exercise.topic
                                   << " against the misconceptions of its exercise.toml";
  }
}

// Else a class of the student's could meet one that GoogleTest makes of a public test, in the check alone.
TEST_F(EveryExercise, KeepsItsPublicTestsInAnUnnamedNamespace) {
  for (const Manifest& exercise : course) {
    const std::string tests = contentOf(source / "exercises" / exercise.topic / "public_test.cpp");
    EXPECT_LT(tests.find("\nnamespace {\n"), tests.find("\nTEST(")) << exercise.topic;
    EXPECT_TRUE(tests.ends_with("\n}  // namespace\n")) << exercise.topic;
  }
}

TEST_F(EveryExercise, NamesFunctionsOfItsContract) {
  for (const Manifest& exercise : course) {
    const std::string contract = contentOf(source / "exercises" / exercise.topic / (exercise.topic + ".h"));
    for (const muelle::Criterion& criterion : exercise.criteria) {
      EXPECT_FALSE(criterion.hint.empty()) << exercise.topic << ": " << criterion.suite << " has no hint";
      EXPECT_FALSE(criterion.functions.empty()) << exercise.topic << ": " << criterion.suite << " names no function";
      for (const std::string& function : criterion.functions) {
        EXPECT_NE(contract.find(function + "("), std::string::npos)
            << exercise.topic << ": criterion " << criterion.suite << " needs " << function;
      }
      for (const std::string& function : criterion.follows) {
        EXPECT_NE(contract.find(function + "("), std::string::npos)
            << exercise.topic << ": criterion " << criterion.suite << " follows " << function;
      }
    }
  }
}

TEST_F(EveryExercise, HasTwoPublicSuitesAtLeast) {
  for (const Manifest& exercise : course) {
    EXPECT_GE(muelle::suitesInSource(contentOf(source / "exercises" / exercise.topic / "public_test.cpp")).size(), 2U)
        << exercise.topic << " has too few public tests";
  }
}

}  // namespace
