#include "grader/authoring/lint.h"
#include "app/instructor/commands.h"
#include "base/progress_bar.h"
#include "base/text/count.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

namespace muelle::app {

namespace fs = std::filesystem;

namespace {

struct LintCommand {
  std::vector<std::string> topics;
  bool grade = false;
  bool filesOnly = false;
  bool manifestsOnly = false;
  int jobs = 2;
};

/// The folders of exercises/, a manifest in them or not; or those that were asked for, which must be there.
std::vector<std::string> chosenTopics(const LintCommand& command, const grader::Workplace& workplace) {
  std::vector<std::string> topics;
  for (const auto& entry : fs::directory_iterator(workplace.exercises())) {
    if (entry.is_directory()) topics.push_back(entry.path().filename().string());
  }
  std::ranges::sort(topics);
  if (command.topics.empty()) return topics;
  for (const std::string& topic : command.topics) {
    if (std::ranges::find(topics, topic) == topics.end()) findExercise(readCourse(workplace.exercises()), topic);
  }
  return command.topics;
}

/// Solution and stub; with --grade all submissions.
grader::TopicMatrix planned(const LintCommand& command, const grader::Workplace& workplace, const Manifest& manifest) {
  grader::MatrixOptions options;
  options.mutants = false;
  grader::TopicMatrix matrix = grader::planMatrix(workplace, manifest, options);
  if (!command.grade) {
    std::erase_if(matrix.rows, [](const grader::MatrixRow& row) {
      return row.kind != grader::MatrixRow::Kind::Solution && row.kind != grader::MatrixRow::Kind::Stub;
    });
  }
  return matrix;
}

/// What can be found by running tests, where the files allow it.
std::vector<grader::Finding> lintRuns(const LintCommand& command, const grader::Workplace& workplace,
                                      const std::string& topic, ProgressBar& bar) {
  std::vector<grader::Finding> findings;
  const std::string place = "exercises/" + topic;
  try {
    const Manifest manifest = readManifest(workplace.exercises() / topic / "exercise.toml");
    findings = grader::lintPublicTests(workplace, manifest);
    std::vector<grader::TopicMatrix> matrices = {planned(command, workplace, manifest)};
    grader::MatrixOptions options;
    options.grading.seed = grader::usualSeed;  // what test-the-tests has graded is not graded again
    options.jobs = command.jobs;
    grader::runMatrix(workplace, matrices, options, [&bar](double fraction) { bar.update(fraction); });
    for (grader::Finding& finding : grader::lintGraded(matrices[0])) findings.push_back(std::move(finding));
  } catch (const std::exception& error) {
    findings.push_back({place, error.what(), "its tests cannot be run until then"});
  }
  return findings;
}

void print(const std::vector<grader::Finding>& findings) {
  for (const grader::Finding& finding : findings) fmt::print("{}\n", finding.text());
}

/// The launcher asks for this before it builds: nothing but the files is there then.
int lintManifests() {
  const std::vector<grader::Finding> findings = grader::lintManifests(grader::Workplace::ofThisBuild().source);
  print(findings);
  return findings.empty() ? 0 : 1;
}

int lint(const LintCommand& command) {
  if (command.manifestsOnly) return lintManifests();
  const grader::Workplace workplace = grader::Workplace::ofThisBuild();
  const std::vector<std::string> topics = chosenTopics(command, workplace);
  long long count = 0;
  for (const std::string& topic : topics) {
    std::vector<grader::Finding> findings = grader::lintFiles(workplace.source, topic);
    if (!command.filesOnly) {
      ProgressBar bar(topic);
      for (grader::Finding& finding : lintRuns(command, workplace, topic, bar)) findings.push_back(std::move(finding));
    }
    print(findings);
    count += static_cast<long long>(findings.size());
  }
  fmt::print("{} in {}\n", counted(count, "finding"), counted(static_cast<long long>(topics.size()), "exercise"));
  return count == 0 ? 0 : 1;
}

}  // namespace

void addLint(CommandLine& program) {
  const auto options = std::make_shared<LintCommand>();
  CommandLine& command = program.command("lint", "Say what an exercise lacks, a line each");
  command.option("TOPIC", options->topics, "Only these exercises [all]");
  const CommandLineOption files = command.flag("--files", options->filesOnly, "Read the files only, run no test");
  command.flag("--manifests", options->manifestsOnly, "Say only which exercise.toml cannot be read, of any exercise")
      .excludes(files);
  command.flag("--grade", options->grade, "Grade every submission, too, also what is known to come out as stated")
      .excludes(files);
  command.option("--jobs,-j", options->jobs, "Submissions at a time [2]").range(1, 256);
  command.footer(
      "Each line says what, where, and what to do. Stub and solution go through the public and the hidden tests. Exit\n"
      "code: 0 nothing is missing, 1 findings, 2 bad usage.\n"
      "Examples: ./muelle lint hanging_chain\n"
      "          ./muelle lint                 # the whole course\n"
      "          ./muelle lint --grade         # and every submission");
  command.action([options] { return lint(*options); });
}

}  // namespace muelle::app
