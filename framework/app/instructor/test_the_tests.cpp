#include "app/instructor/commands.h"
#include "app/instructor/run_ctest.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "grader/authors/mistake_text.h"
#include "grader/matrix/corpus_share.h"
#include "grader/matrix/matrix_text.h"
#include "grader/matrix/sentences.h"
#include "grader/record.h"

#include <fmt/format.h>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace muelle::app {

namespace fs = std::filesystem;

namespace {

struct MatrixCommand {
  std::vector<std::string> topics;
  std::string csv;
  std::string seed = grader::usualSeed;  ///< another one tries other inputs
  std::string sandbox = "auto";
  bool noMutants = false;
  bool unnamed = false;
  bool fresh = false;
  bool remember = false;
  int share = 1;
  int jobs = 2;
};

/// The exercises that were asked for, else those that have submissions.
std::vector<Manifest> chosen(const MatrixCommand& command, const grader::Workplace& workplace) {
  const std::vector<Manifest> course = readCourse(workplace.exercises());
  std::vector<Manifest> manifests;
  for (const std::string& topic : command.topics) manifests.push_back(findExercise(course, topic));
  if (!command.topics.empty()) return manifests;
  for (const Manifest& manifest : course) {
    if (fs::exists(workplace.source / "tests" / "submissions" / manifest.topic)) manifests.push_back(manifest);
  }
  return manifests;
}

/// The corpora that have tests of their own: attacks, and hand-ins that check and grade must judge alike.
bool restOfTheCorpora() {
  setenv("MUELLE_SHARE", "all", 1);
  return runCtest({"--label-regex", "^(hostile|parity)$"}) == 0;
}

/// Compares what students are told with tests/submissions/TOPIC/sentences.txt; --remember writes that file anew, or,
/// with a share, adds to it.
bool sentencesAreKnown(const grader::Workplace& workplace, const grader::TopicMatrix& matrix,
                       const MatrixCommand& command) {
  const fs::path file = workplace.source / "tests" / "submissions" / matrix.manifest.topic / "sentences.txt";
  if (command.remember) {
    std::set<std::string> sentences = matrix.sentences;
    if (command.share != 1) sentences.merge(grader::readSentences(file));
    grader::writeSentences(file, sentences);
    return true;
  }
  const bool isUsual = command.seed == grader::usualSeed;
  const std::vector<std::string> lines =
      grader::differencesOfSentences(file, matrix.sentences, command.share == 1 && isUsual);
  for (const std::string& line : lines) fmt::print("  ! {}\n", line);
  return lines.empty();
}

/// Wrong submissions without a name, those with the same answers together, and what an author pastes to name them.
void printUnnamed(const grader::Workplace& workplace, const grader::TopicMatrix& matrix,
                  const grader::MatrixOptions& options) {
  const std::string contract = readFile(workplace.contract(matrix.manifest.topic));
  for (const auto& group : grader::gradeAgain(workplace, options.grading, matrix.unnamed, options.jobs)) {
    fmt::print("{}\n", grader::groupText(group, contract));
  }
}

/// True when everything came out as stated.
bool gradeMatrices(const MatrixCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  const grader::Workplace workplace = grader::Workplace::ofThisBuild();
  grader::MatrixOptions options;
  options.grading.seed = command.seed;
  options.grading.sandbox = grader::parseSandboxChoice(command.sandbox);
  options.grading.fresh = command.fresh;
  options.mutants = !command.noMutants;
  options.share = command.share;
  options.jobs = command.jobs;
  std::vector<grader::TopicMatrix> matrices;
  for (const Manifest& manifest : chosen(command, workplace)) {
    matrices.push_back(grader::planMatrix(workplace, manifest, options));
  }
  {
    ProgressBar bar("grading submissions and mutants");
    grader::runMatrix(workplace, matrices, options, [&bar](double fraction) { bar.update(fraction); });
  }
  bool good = true;
  for (const grader::TopicMatrix& matrix : matrices) {
    fmt::print("{}\n", grader::matrixText(matrix));
    if (command.unnamed) printUnnamed(workplace, matrix, options);
    const bool isGood = matrix.good() && sentencesAreKnown(workplace, matrix, command);
    good = good && isGood;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}{}time                      {:.0f} s\n", grader::summaryText(grader::summarise(matrices)),
             command.share > 1 ? fmt::format("share                     one in {}\n", command.share) : "", seconds);
  if (!good) fmt::print("to mend                   what is marked with ! above\n");
  if (!command.csv.empty()) muelle::writeFile(command.csv, grader::matrixCsv(matrices));
  return good;
}

int testTheTests(const MatrixCommand& command) {
  const bool isWhole = command.topics.empty() && !command.noMutants && command.share == 1;
  if (command.remember && command.topics.empty() && (command.noMutants || command.share != 1)) {
    throw std::runtime_error(
        "--remember without TOPIC notes the whole corpus as known: leave --no-mutants and --share out");
  }
  bool good = gradeMatrices(command);
  if (isWhole) good = restOfTheCorpora() && good;
  if (good && command.remember) {
    grader::rememberCorpus(grader::Workplace::ofThisBuild().source / "tests" / "submissions", command.topics);
  }
  return good ? 0 : 1;
}

}  // namespace

void addTestTheTests(CommandLine& program) {
  const auto options = std::make_shared<MatrixCommand>();
  CommandLine& command = program.command(
      "test-the-tests", "Grade submissions of known worth and mutants of the solutions: the kill matrix");
  command.option("TOPIC", options->topics, "Only these exercises [all that have submissions]");
  command.flag("--no-mutants", options->noMutants, "Only the submissions of tests/submissions");
  command
      .option("--share", options->share,
              "One mutant and one known submission in so many, and all that are new or changed [1: all]")
      .range(1, 1000);
  command.option("--jobs,-j", options->jobs, "Submissions at a time [2]").range(1, 256);
  command.option("--csv", options->csv, "Also write every verdict to this file");
  command.option("--seed", options->seed, "Other random inputs than the usual ones");
  command.option("--sandbox", options->sandbox, "auto, bubblewrap, landlock or unsafe [auto]");
  command.flag("--fresh", options->fresh, "Grade again what has been graded before");
  command.flag("--unnamed", options->unnamed,
               "Also group the wrong ones without a name by their answers, each group with a MUELLE_MISTAKE to paste");
  command.flag("--remember", options->remember,
               "When all is as stated, note the submissions as known: ./muelle test then takes a share of them; with "
               "--share what is new, too");
  command.footer(
      "x lost, . passed, ! otherwise than its first line states. Exit code: 0 when every row is exact and every\n"
      "surviving mutant has its reason in tests/submissions/TOPIC/mutants.toml, else 1. Without TOPIC the attacks and "
      "the\n"
      "hand-ins that check and grade judge alike are tested, too. Two listed mistakes that give the same numbers in "
      "every\n"
      "call of an exercise make the exit code 1, too.\n"
      "Examples: ./muelle test-the-tests spring_3d --no-mutants\n"
      "          ./muelle test-the-tests spring_3d --no-mutants --unnamed");
  command.action([options] { return testTheTests(*options); });
}

}  // namespace muelle::app
