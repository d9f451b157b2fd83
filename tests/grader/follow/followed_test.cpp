#include "grader/report/followed.h"

#include "grader/record.h"
#include "grader/report/report.h"
#include "sample.h"

#include "base/file.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

/// The force is wrong, and the acceleration was earned in spite of it.
GradedSubmission followedSubmission() {
  Verdict acceleration = verdict("Acceleration", 2, 0);
  acceleration.followed = {"springForce"};
  GradedSubmission graded;
  graded.name = "a student";
  graded.exercises = {with(with(exerciseWithoutVerdicts(), verdict("HookeForce", 0, 1)), acceleration)};
  return graded;
}

constexpr const char* expected = "one mistake, in springForce, costs these 4 points; what you built on it is right.";

int count(const std::string& text) {
  int found = 0;
  for (std::size_t at = text.find(expected); at != std::string::npos; at = text.find(expected, at + 1)) ++found;
  return found;
}

TEST(Followed, IsSaidOnceInEveryReport) {
  const GradedSubmission graded = followedSubmission();
  EXPECT_EQ(score(graded), 3.0);
  EXPECT_EQ(count(htmlPage(graded)), 1);
  EXPECT_EQ(count(terminalTable(graded, false, 110)), 1);
  EXPECT_EQ(count(resultsJson(graded)), 1);
  EXPECT_EQ(count(junitXml(graded)), 1);
}

TEST(Followed, IsKeptInTheRecord) {
  const TemporaryFolder folder(std::filesystem::temp_directory_path());
  Verdict written = verdict("Acceleration", 2, 0);
  written.followed = {"springForce", "other"};
  writeRecord(written, folder.path() / "record.json");
  const auto read = readRecord(folder.path() / "record.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->followed, written.followed);
}

TEST(Followed, SaysNothingOfALowerFunctionThatLostNothing) {
  GradedSubmission graded = followedSubmission();
  graded.exercises[0].verdicts.at("HookeForce") = verdict("HookeForce", 2, 0);
  EXPECT_TRUE(followedSentences(graded.exercises[0]).empty());
}

}  // namespace
}  // namespace muelle::grader
