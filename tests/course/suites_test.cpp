/// \file
/// Where a manifest and its tests disagree, both files are named.

#include "course/suites.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <filesystem>

namespace muelle {
namespace {

const std::string toml = "exercises/a/exercise.toml";
const std::string testFile = "tests/hidden/a/a_test.cpp";

Manifest paying(const std::vector<std::string>& suites) {
  Manifest manifest;
  for (const std::string& suite : suites) {
    Criterion criterion;
    criterion.suite = suite;
    manifest.criteria.push_back(criterion);
  }
  return manifest;
}

TEST(Disagreements, AreNoneWhereEachCriterionHasASuiteWithTests) {
  EXPECT_TRUE(disagreements(paying({"Force", "Energy"}), {{"Energy", 1}, {"Force", 3}}, toml, testFile).empty());
}

TEST(Disagreements, NameASuiteThatPaysNothing) {
  const auto lines = disagreements(paying({"Force"}), {{"Force", 1}, {"Forces", 2}}, toml, testFile);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "tests/hidden/a/a_test.cpp: suite Forces is no criterion of exercises/a/exercise.toml; add a [[criterion]] "
            "with suite = \"Forces\", or rename the suite; did you mean 'Force'?");
}

TEST(Disagreements, NameACriterionThatNothingTests) {
  const auto lines = disagreements(paying({"Force", "Energy"}), {{"Force", 1}}, toml, testFile);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "exercises/a/exercise.toml: criterion Energy has no suite in tests/hidden/a/a_test.cpp; write "
            "TEST(Energy, ...), or take the criterion out");
}

TEST(Disagreements, NameASuiteOfWhichNoTestRuns) {
  const auto lines = disagreements(paying({"Force"}), {{"Force", 0}}, toml, testFile);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "tests/hidden/a/a_test.cpp: suite Force, a criterion of exercises/a/exercise.toml, is empty: no test of it "
            "runs");
}

TEST(Disagreements, OfPublicTestsNeedNoSuiteForACriterion) {
  EXPECT_TRUE(publicDisagreements(paying({"Force", "Energy"}), {{"Force", 1}}, toml, testFile).empty());
  EXPECT_EQ(publicDisagreements(paying({"Force"}), {{"Other", 1}, {"Force", 0}}, toml, testFile).size(), 2U);
}

/// A manifest that names a suite "Forse", in a checkout with public tests of "Force" and, an author's, hidden ones.
TEST(Disagreements, OfAMisspeltSuiteAreOneLine) {
  const TemporaryFolder checkout(std::filesystem::path(build_paths::binary) / "test");
  Manifest manifest = paying({"Forse", "Energy"});
  manifest.topic = "a";
  EXPECT_EQ(firstDisagreement(checkout.path(), manifest), "") << "there is nothing to compare with";
  std::filesystem::create_directories(checkout.path() / "exercises/a");
  writeFile(checkout.path() / "exercises/a/public_test.cpp", "TEST(Force, Pulls) {}\n");
  EXPECT_TRUE(
      firstDisagreement(checkout.path(), manifest)
          .starts_with("exercises/a/public_test.cpp: suite Force is no criterion of exercises/a/exercise.toml"));
  std::filesystem::create_directories(checkout.path() / "tests/hidden/a");
  writeFile(checkout.path() / testFile, "TEST(Force, Pulls) {}\nTEST(Energy, IsKept) {}\n");
  EXPECT_EQ(firstDisagreement(checkout.path(), manifest),
            "exercises/a/exercise.toml: criterion Forse has no suite in tests/hidden/a/a_test.cpp; write "
            "TEST(Forse, ...), or take the criterion out; did you mean 'Force'?");
  manifest.criteria[0].suite = "Force";
  EXPECT_EQ(firstDisagreement(checkout.path(), manifest), "");
}

TEST(SuitesInSource, AreReadOfTheMacros) {
  const auto suites = suitesInSource(
      "#include <gtest/gtest.h>\n"
      "// TEST(Comment, IsNone) {}\n"
      "TEST(Force, PullsWhenStretched) {}\n"
      "TEST_F( Energy ,\n       IsKept) {}\n"
      "TEST(Force, DISABLED_Later) {}\n"
      "TEST(DISABLED_Whole, One) {}\n");
  ASSERT_EQ(suites.size(), 3U);
  EXPECT_EQ(suites[0].name, "Force");
  EXPECT_EQ(suites[0].tests, 1);
  EXPECT_EQ(suites[1].name, "Energy");
  EXPECT_EQ(suites[1].tests, 1);
  EXPECT_EQ(suites[2].name, "DISABLED_Whole");
  EXPECT_EQ(suites[2].tests, 0);
}

}  // namespace
}  // namespace muelle
