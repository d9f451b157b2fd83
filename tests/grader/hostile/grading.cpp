#include "grading.h"

#include "base/file.h"
#include "course/testing/print_value.h"
#include "grader/report/report.h"

#include <gtest/gtest.h>
#include <algorithm>

#include <nlohmann/json.hpp>
#include <regex>

namespace muelle::grader {

namespace {

SandboxChoice chosenSandbox() {
  const char* name = std::getenv("MUELLE_SANDBOX");
  return parseSandboxChoice(name != nullptr ? name : "");
}

/// Everything that the student reads about one exercise.
std::string allFeedback(const GradedExercise& graded) {
  std::string text = graded.build.message + '\n' + graded.build.diagnostics + '\n';
  for (const Criterion& criterion : graded.manifest.criteria) {
    for (const std::string& line : feedback(criterion, graded)) text += line + '\n';
  }
  return text;
}

void expectNoPoints(const GradedExercise& graded) {
  for (const Criterion& criterion : graded.manifest.criteria) {
    const auto points = score(criterion, graded);
    ASSERT_TRUE(points.has_value()) << criterion.suite << ": the grader is at fault: "
                                    << (graded.verdicts.contains(criterion.suite)
                                            ? graded.verdicts.at(criterion.suite).graderFault
                                            : graded.build.message);
    EXPECT_EQ(*points, 0.0) << criterion.suite;
  }
}

/// A submission's output must not hold a number that only the hidden test knows.
void expectNothingLeaked(const Verdict& verdict) {
  constexpr std::size_t telling = 6;  // digits; a shorter number is anybody's
  for (const TestOutcome& test : verdict.tests) {
    for (const Mismatch& mismatch : test.mismatches) {
      const std::string expected = printNumber(mismatch.expected);
      if (expected.size() < telling) continue;
      EXPECT_EQ(verdict.output.find(expected), std::string::npos) << expected;
    }
  }
  EXPECT_LT(verdict.output.size(), 70'000U);
}

void expectTameReports(const GradedSubmission& graded) {
  const std::string page = htmlPage(graded);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find('\0'), std::string::npos);
  for (const std::string& text : {page, terminalTable(graded, false, 100), junitXml(graded), resultsJson(graded)}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos) << "a right-to-left mark stands in a report";
    EXPECT_LT(text.size(), 4'000'000U);
  }
  EXPECT_TRUE(nlohmann::json::accept(resultsJson(graded)));
}

}  // namespace

GradedSubmission gradeAttack(const std::filesystem::path& submission, const std::string& topic, bool judgesSymbols) {
  const TemporaryFolder kept(std::filesystem::temp_directory_path());
  Workplace workplace = Workplace::ofThisBuild();
  workplace.kept = kept.path();
  workplace.judgesSymbols = judgesSymbols;
  GradeOptions options;
  options.seed = "hostile";
  options.sandbox = chosenSandbox();
  options.withCurves = false;
  Grader grader = openGrader(workplace, options, {topic});
  return grade(grader, grader.take(submission), 1);
}

void expectDefeated(const GradedSubmission& graded, const std::string& says) {
  for (const GradedExercise& exercise : graded.exercises) {
    expectNoPoints(exercise);
    for (const auto& [suite, verdict] : exercise.verdicts) expectNothingLeaked(verdict);
    std::string words = allFeedback(exercise);
    std::ranges::replace(words, '\n', ' ');  // a sentence may end on the next line
    EXPECT_TRUE(says.empty() || std::regex_search(words, std::regex(says))) << says << " is not said in\n" << words;
  }
  expectTameReports(graded);
}

}  // namespace muelle::grader
