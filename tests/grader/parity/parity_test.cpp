/// \file
/// Every right and wrong submission, every solution, and every hostile one that acts through the C library has the same
/// class of outcome in `check` and in `grade`, on the inputs of the public tests.
///
/// A pair costs three to six seconds of processor time. A share of the known submissions is taken, whatever is new or
/// changed always (corpus_share.h), and one solution in four; MUELLE_SHARE=all takes everything, MUELLE_SHARE=N one in
/// N.

#include "confined_check.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "base/process/child.h"
#include "grader/built_exercises.h"
#include "grader/matrix/corpus_share.h"
#include "grader/run/grade.h"
#include "support/manifest_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

const fs::path source = build_paths::source;

/// Submissions that need not come out alike.
struct Exception {
  std::string_view name;
  std::string_view reason;
};
/// Most act without the C library, and so by no symbol that could refuse them: what ends them in `grade` is the
/// sandbox, which a student's machine does not have.
constexpr auto exceptions = std::to_array<Exception>({
    {"system_call_by_hand", "asks the kernel by an instruction of its own"},
    {"data_as_code", "asks the kernel by an instruction that it keeps as data"},
    {"forged_signal_frame", "asks the kernel by an instruction of its own"},
    {"other_architecture", "asks the kernel by an instruction of its own"},
    {"has_include_oracle", "asks the compiler for files that a student's machine has"},
    {"huge_initialiser", "meets the compiler's limits of time and of memory at nearly the same moment"},
});

bool isExcepted(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return folder.parent_path().filename() == "hostile" &&
         std::ranges::find(exceptions, name, &Exception::name) != exceptions.end();
}

int share() { return std::getenv("MUELLE_SHARE") == nullptr ? 2 * usualShare : shareOfEnvironment(); }

Workplace workplaceOfPublicTests() {
  Workplace workplace = Workplace::ofThisBuild();
  workplace.binary = MUELLE_PARITY;
  return workplace;
}

std::vector<fs::path> submissions() {
  const fs::path corpus = source / "tests" / "submissions";
  const CorpusShare taken(corpus, share());
  std::vector<fs::path> folders;
  for (fs::path folder : submissionsIn(corpus)) {
    const bool isPart = folder.parent_path().parent_path().filename() == "hostile";
    if (isPart) folder = folder.parent_path();  // a submission that brings folders of its own
    const bool isKnown = !folders.empty() && folders.back() == folder;
    if (!isKnown && !isExcepted(folder) && (isPart || taken.takes(folder))) folders.push_back(folder);
  }
  const std::vector<fs::path> solutions = submissionsIn(source / "solutions");
  for (std::size_t i = 0; i < solutions.size(); i += share() == 1 ? 1 : 4) folders.push_back(solutions[i]);
  const BuiltExercises built(workplaceOfPublicTests());
  std::erase_if(folders, [&built](const fs::path& folder) { return !built.haveOneOf(folder); });
  return folders;
}

/// "spring_1d_wrong_halved"
std::string nameOfTest(const ::testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.lexically_relative(source / "tests" / "submissions").generic_string();
  if (name.starts_with("../")) name = "solution_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

/// A criterion for each suite of the public tests, in their order.
std::vector<Criterion> publicCriteria(const Workplace& workplace, const Manifest& manifest) {
  ChildSpec spec;
  spec.command = {workplace.hiddenProgram(manifest.topic).string(), "--list"};
  std::istringstream lines(runCommand(spec, {}).out);
  std::vector<Criterion> criteria;
  for (std::string kind, name; lines >> kind && std::getline(lines >> std::ws, name);) {
    if (kind != "suite") continue;
    Criterion criterion;
    const auto stated = std::ranges::find(manifest.criteria, name, &Criterion::suite);
    if (stated != manifest.criteria.end()) criterion = *stated;
    criterion.follows.clear();  // check knows no lower functions, and the public tests register no arguments
    criterion.suite = name;
    criterion.points = 1;
    criteria.push_back(criterion);
  }
  return criteria;
}

std::string wordsOf(const GradedExercise& graded) {
  std::string words = graded.build.message + "\n";
  for (const auto& [suite, verdict] : graded.verdicts) {
    words += suite + ": " + std::string(nameOf(verdict.outcome)) + " " + verdict.fault + verdict.neverWritten + "\n";
  }
  return words;
}

/// The class of all criteria together, as check sorts its tests.
Outcome outcomeOf(const GradedExercise& graded) {
  if (graded.build.status != BuildOutcome::Status::Built) return graded.build.outcome;
  Outcome worst = Outcome::Passed;
  for (const Criterion& criterion : graded.manifest.criteria) {
    const Outcome outcome = graded.verdicts.at(criterion.suite).outcome;
    const bool endsTheCalls =
        outcome != Outcome::Passed && outcome != Outcome::Wrong && outcome != Outcome::NeverWritten;
    if (endsTheCalls) return outcome;
    if (outcome == Outcome::NeverWritten || worst == Outcome::Passed) worst = outcome;
  }
  return worst;
}

class Parity : public ::testing::TestWithParam<fs::path> {};

TEST_P(Parity, OfCheckAndGrade) {
  std::unique_ptr<Sandbox> sandbox;
  try {
    sandbox = makeSandbox(SandboxChoice::Bubblewrap);
  } catch (const std::exception& error) {
    GTEST_SKIP() << "check is run in bubblewrap only: " << error.what();
  }
  const Workplace workplace = workplaceOfPublicTests();
  Manifest manifest = manifestOf(GetParam(), source / "exercises");
  manifest.criteria = publicCriteria(workplace, manifest);
  ASSERT_FALSE(manifest.criteria.empty());
  GradeOptions options;
  options.sandbox = SandboxChoice::Bubblewrap;
  options.withCurves = false;
  Grader grader(workplace, {manifest}, options, std::move(sandbox));

  const Submission submission = grader.take(GetParam());
  const GradedExercise graded = grade(grader, submission, 1).exercises.front();
  ASSERT_FALSE(hasGraderFault(graded)) << wordsOf(graded);
  // The file as it was handed in: check reads it in its own way.
  Sources files;
  for (const std::string& name : manifest.files) files[name] = readFile(GetParam() / name);
  const Checked checked = checkConfined(grader.sandbox(), manifest, files);
  ASSERT_EQ(checked.trouble, "") << "grade: " << nameOf(outcomeOf(graded)) << "\n" << wordsOf(graded);
  EXPECT_EQ(nameOf(checked.outcome), nameOf(outcomeOf(graded)))
      << "check says: " << checked.words << "\ngrade says: " << wordsOf(graded);
}

INSTANTIATE_TEST_SUITE_P(Submission, Parity, ::testing::ValuesIn(submissions()), nameOfTest);

TEST(Exceptions, AreHostileSubmissionsThatThereAre) {
  for (const Exception& exception : exceptions) {
    EXPECT_TRUE(fs::exists(source / "tests" / "submissions" / "hostile" / exception.name)) << exception.name;
    EXPECT_FALSE(exception.reason.empty()) << exception.name;
  }
}

}  // namespace
}  // namespace muelle::grader
