#include "grader/matrix/sentences.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

GradedExercise told(const std::string& fault) {
  GradedExercise exercise;
  exercise.build.status = BuildOutcome::Status::Built;
  exercise.manifest.topic = "spring";
  exercise.manifest.criteria = {{"Force", "Force", 1.0, false, "", {}, {}}};
  Verdict verdict;
  verdict.topic = "spring";
  verdict.suite = "Force";
  verdict.tests = {{"Fails", "the force on xa is -k (L - L0)", false, {}, ""}};
  verdict.fault = fault;
  exercise.verdicts["Force"] = verdict;
  return exercise;
}

TEST(Sentences, AreOneForManyNumbers) {
  const std::set<std::string> found = sentencesOf(told("f(Vec3(-1.5, 2e-9, 0x1p-30), {1, 2}, L0) takes 3."));
  EXPECT_EQ(found, (std::set<std::string>{"f(Vec3(#), {#}, L0) takes #.", "not yet: the force on xa is -k (L - L0)"}));
}

TEST(Sentences, AreHeldAgainstTheGoldenFile) {
  const TemporaryFolder folder(::testing::TempDir());
  const std::filesystem::path file = folder.path() / "sentences.txt";
  EXPECT_TRUE(differencesOfSentences(file, {"a"}, true).empty()) << "without a file nothing is compared";
  writeSentences(file, {"a", "b"});
  EXPECT_TRUE(differencesOfSentences(file, {"a", "b"}, true).empty());
  EXPECT_TRUE(differencesOfSentences(file, {"a"}, false).empty());
  EXPECT_EQ(differencesOfSentences(file, {"a"}, true).size(), 1U);
  EXPECT_EQ(differencesOfSentences(file, {"a", "b", "c"}, false).size(), 1U);
}

/// What GoogleTest says of its own expectations is C++ with names of the test's.
TEST(Sentences, AreNoneOfGoogleTests) {
  const std::filesystem::path submissions = std::filesystem::path(build_paths::source) / "tests" / "submissions";
  int files = 0;
  for (const auto& folder : std::filesystem::directory_iterator(submissions)) {
    const std::filesystem::path file = folder.path() / "sentences.txt";
    if (!std::filesystem::exists(file)) continue;
    const std::string told = readFile(file);
    for (const char* words : {"Expected: (", "Expected equality", "Which is:", "Value of:"}) {
      EXPECT_EQ(told.find(words), std::string::npos) << file << " has " << words;
    }
    ++files;
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace muelle::grader
