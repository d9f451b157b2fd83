/// \file
/// What `muelle new` writes, built as every exercise is: it builds, every file is read by what reads an exercise's, and
/// the two tests that its author has to take out are all that fails.

#include "grader/authoring/scaffold.h"
#include "course/check/exercise_check.h"
#include "course/contract.h"
#include "course/suites.h"
#include "grader/authoring/lint.h"
#include "grader/matrix/matrix.h"
#include "grader/run/grade.h"

#include "base/file.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

const fs::path course = MUELLE_SCAFFOLD;
const std::string topic = "first_draft";

class Scaffold : public testing::Test {
 protected:
  Scaffold() {
    workplace_.source = course;
    workplace_.kept = course / "kept";
  }

  fs::path file(const std::string& room, const std::string& name) const { return course / room / topic / name; }

  /// "Suite.Name" of the public tests that fail.
  std::set<std::string> publicFailures(const fs::path& source) const {
    const CheckFolders folders{course / "exercises", workplace_.binary, course / "out"};
    const TestReport report = runPublicTests(buildStudentProgram(manifest_, {source}, folders));
    EXPECT_EQ(report.crash, "");
    EXPECT_GT(report.total, 1);
    std::set<std::string> names;
    for (const FailedTest& test : report.failures) names.insert(test.suite + "." + test.name);
    return names;
  }

  Workplace workplace_ = Workplace::ofThisBuild();
  Manifest manifest_ = readManifest(file("exercises", "exercise.toml"));
};

TEST_F(Scaffold, FailsInPublicWhereItsAuthorHasToWrite) {
  const std::string name = topic + ".cpp";
  EXPECT_EQ(publicFailures(file("solutions", name)), std::set<std::string>{"Force.StillToBeWritten"});
  EXPECT_EQ(publicFailures(file("exercises", name)).size(), 2U) << "the stub is wrong besides";
}

TEST_F(Scaffold, FailsHiddenTestsWhereItsAuthorHasToWrite) {
  GradeOptions options;
  options.seed = "a scaffold";
  auto sandbox = makeSandbox(options.sandbox);
  Grader grader(workplace_, {manifest_}, options, std::move(sandbox));
  const GradedSubmission graded = grade(grader, grader.take(course / "solutions"), 2);
  const Verdict& verdict = graded.exercises.at(0).verdicts.at("Force");
  EXPECT_EQ(verdict.graderFault, "");
  EXPECT_EQ(verdict.tests.size(), 3U);
  for (const TestOutcome& test : verdict.tests) EXPECT_EQ(test.passed, test.name != "StillToBeWritten") << test.name;
  EXPECT_FALSE(graded.exercises.at(0).figures.empty()) << graded.exercises.at(0).figuresNote;
}

TEST_F(Scaffold, HasSubmissionsThatComeOutAsStated) {
  MatrixOptions options;
  options.grading.seed = "a scaffold";
  std::vector<TopicMatrix> matrices = {planMatrix(workplace_, manifest_, options)};
  runMatrix(workplace_, matrices, options);
  for (const MatrixRow& row : matrices[0].rows) {
    const bool losesAnyway = row.kind == MatrixRow::Kind::Wrong || row.kind == MatrixRow::Kind::Stub;
    EXPECT_EQ(row.exact(), losesAnyway) << row.name << ": " << row.trouble;
  }
  EXPECT_TRUE(matrices[0].endsNotPassed.empty());
  EXPECT_TRUE(matrices[0].mistakesNotToldApart.empty());
}

TEST_F(Scaffold, IsReadByAllThatReadsExercises) {
  const std::string contract = readFile(file("exercises", topic + ".h"));
  EXPECT_EQ(functionsOf(contract), std::vector<std::string>{"firstDraftForce"});
  EXPECT_EQ(rangesOf(contract).size(), 2U);
  EXPECT_TRUE(
      publicDisagreements(manifest_, suitesInSource(readFile(file("exercises", "public_test.cpp"))), "", "").empty());
  EXPECT_EQ(manifest_.title, "First draft");
}

TEST_F(Scaffold, IsLintedLineByLine) {
  std::set<std::string> marked, told;
  for (const auto& entry : fs::recursive_directory_iterator(course)) {
    if (!entry.is_regular_file() || entry.path().string().find(topic) == std::string::npos) continue;
    const std::string text = readFile(entry.path());
    int line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text.compare(i, 6, writeMark) == 0) {
        marked.insert(entry.path().lexically_relative(course).string() + ":" + std::to_string(line));
      }
      line += text[i] == '\n' ? 1 : 0;
    }
  }
  EXPECT_GT(marked.size(), 15U);
  for (const Finding& finding : lintFiles(course, topic)) {
    if (finding.what.starts_with("still to be written")) told.insert(finding.where);
  }
  EXPECT_EQ(told, marked);
}

}  // namespace
}  // namespace muelle::grader
