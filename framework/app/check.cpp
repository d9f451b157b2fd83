#include "app/commands.h"
#include "base/build_paths.h"
#include "base/terminal.h"
#include "base/text/printable.h"
#include "course/check/compile_rules.h"
#include "course/check/exercise_check.h"
#include "course/check/fault_sentences.h"
#include "course/check/handed_out.h"
#include "course/check/prediction.h"
#include "course/check/public_parts.h"
#include "course/manifest.h"
#include "course/suites.h"
#include "course/unfinished.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace muelle::app {

namespace fs = std::filesystem;

namespace {

struct CheckOptions {
  std::string topic;
  std::string file;
  std::string predict;
  bool noPlot = false;
  bool all = false;
};

/// As the student would type it.
std::string shortPath(const fs::path& path) {
  std::error_code error;
  const fs::path relative = fs::relative(path, error);
  const bool isBelow = !error && !relative.empty() && *relative.begin() != "..";
  return (isBelow ? relative : path).string();
}

/// What the student's own code printed, between two lines that say so.
void printOutput(const std::string& output) {
  if (output.empty()) return;
  fmt::print("{}\n{}\n", dim("  your code printed:"), indented(printableText(cutText(output, 20, 2000)), "  | "));
}

/// "./muelle check" of one exercise.
class Check {
 public:
  Check(const Manifest& exercise, const CheckOptions& options) : exercise_(exercise), options_(options) {
    for (const std::string& name : exercise.files) {
      sources_.push_back(options.file.empty() ? folders_.exercises / exercise.topic / name : fs::path(options.file));
    }
  }

  /// Prints the verdict, then draws; true when everything passes.
  bool run() {
    requireAnswer();
    nameChanged();
    nameDisagreement();
    if (compilesWithClang()) {
      fmt::print("{}\n", dim(fmt::format("compiled with {}; the course is graded with g++", build_paths::compiler)));
    }
    buildPublicParts(folders_.build, exercise_.topic);
    const StudentProgram program = buildStudentProgram(exercise_, sources_, folders_);
    if (!program.note.empty()) fmt::print("{}\n", dim(printableLine(program.note)));
    if (program.executable.empty()) {
      fmt::print("{} {}: {}\n\n{}\n", red("✗"), bold(exercise_.topic), printableLine(program.message),
                 program.diagnostics);
      printNext();
      return false;
    }
    const TestReport report = runPublicTests(program);
    printVerdict(report, program);
    // The verdict is what the student waits for; the curves may follow.
    std::fflush(stdout);
    if (!options_.noPlot) draw(program);
    if (!report.allPassed()) printNext();
    return report.allPassed();
  }

 private:
  void requireAnswer() const {
    const Prediction& predict = exercise_.predict;
    if (options_.predict.empty() || chosenAnswer(predict, options_.predict)) return;
    if (predict.question.empty()) {
      throw std::invalid_argument(fmt::format("--predict: {} asks for no prediction; leave it out", exercise_.topic));
    }
    throw std::invalid_argument(fmt::format("--predict {}: answer with a number, {}", printableLine(options_.predict),
                                            numberedAnswers(predict, ", ")));
  }

  /// What is unfinished for lack of such a file has been named before any command.
  void nameChanged() const {
    if (unfinishedExercises(build_paths::binary).contains(exercise_.topic)) return;
    fmt::print("{}", sayChanged(build_paths::source, exercise_.topic));
    std::fflush(stdout);
  }

  /// A criterion whose suite is misspelt has no hint here, and nobody can earn it.
  void nameDisagreement() const {
    const std::string line = firstDisagreement(build_paths::source, exercise_);
    if (line.empty()) return;
    const char* whose = isAuthors(build_paths::source) ? "" : " (so it was handed out: tell your instructor)";
    fmt::print("{}{}\n", line, whose);
    std::fflush(stdout);
  }

  void printVerdict(const TestReport& report, const StudentProgram& program) const {
    if (report.allPassed()) {
      fmt::print("{} {}: all {} public tests pass\n", green("✓"), bold(exercise_.topic), report.total);
    } else {
      fmt::print("{} {}: {}\n", red("✗"), bold(exercise_.topic), countTests(report));
    }
    if (!program.diagnostics.empty()) fmt::print("\n{}", program.diagnostics);
    if (!report.allPassed()) printFirst(report);
    printOutput(report.output);
  }

  /// The first thing to mend, and the hint of its criterion.
  void printFirst(const TestReport& report) const {
    if (report.failures.empty()) {
      fmt::print("\n  {}\n", printableText(report.crash.empty() ? "no test ran" : report.crash));
      return;
    }
    const FailedTest& first = report.failures.front();
    const auto criterion = std::ranges::find(exercise_.criteria, first.suite, &Criterion::suite);
    const bool isKnown = criterion != exercise_.criteria.end();
    fmt::print("\n{} {}\n", bold("mend first:"),
               isKnown ? criterion->name : (first.suite.empty() ? loadingCode : first.suite));
    const std::vector<Misconception> mistakes = mistakesIn(first, report);
    for (const Misconception& mistake : mistakes) fmt::print("  {}\n", mistake.says);
    fmt::print("{}", showFailure(first));
    for (const Misconception& mistake : mistakes) {
      if (!mistake.hint.empty()) fmt::print("  {} {}\n", bold("hint:"), mistake.hint);
    }
    if (isKnown && mistakes.empty()) fmt::print("  {} {}\n", bold("hint:"), criterion->hint);
    fmt::print("\n");
  }

  /// Those named mistakes whose function the failed test has called.
  std::vector<Misconception> mistakesIn(const FailedTest& test, const TestReport& report) const {
    std::vector<Misconception> mistakes = namedMistakes(report, exercise_);
    std::erase_if(mistakes, [&test](const Misconception& m) { return !test.call.starts_with(m.function + "("); });
    return mistakes;
  }

  void draw(const StudentProgram& program) const {
    const std::optional<std::string> prediction = predicted();
    const std::string remark = prediction ? "you predicted: " + *prediction : "";
    const CurvesReport curves = drawCurves(program, folders_.out / exercise_.topic, remark);
    for (const fs::path& figure : curves.figures) {
      const bool isFirst = &figure == &curves.figures.front();
      fmt::print("  curve: {}{}\n", shortPath(figure), isFirst && prediction ? fmt::format("  ({})", remark) : "");
    }
    if (!curves.trouble.empty()) fmt::print("  no curves: {}\n", curves.trouble);
  }

  /// What the student expects of the curve: given on the command line, kept from an earlier time, or asked for on a
  /// terminal, before the curve is seen.
  std::optional<std::string> predicted() const {
    const Prediction& predict = exercise_.predict;
    if (predict.question.empty()) return std::nullopt;
    const fs::path folder = folders_.out / exercise_.topic;
    std::optional<std::string> answer = chosenAnswer(predict, options_.predict);
    if (!answer) answer = keptPrediction(predict, folder);
    if (!answer && isTalkedTo()) answer = ask(predict);
    if (answer) keepPrediction(*answer, folder);
    return answer;
  }

  static std::optional<std::string> ask(const Prediction& predict) {
    fmt::print("\n{} {}\n  {}\nyour prediction (1 to {}, for no points; Enter to leave it): ",
               bold("before the curve:"), predict.question, numberedAnswers(predict, "\n  "), predict.answers.size());
    std::fflush(stdout);
    std::string line;
    std::getline(std::cin, line);
    return chosenAnswer(predict, line);
  }

  void printNext() const {
    const std::string file = options_.file.empty() ? "" : fmt::format(" --file {}", options_.file);
    fmt::print("{} edit {}, then type  ./muelle check {}{}\n", bold("next:"), shortPath(sources_.front()),
               exercise_.topic, file);
  }

  const Manifest& exercise_;
  const CheckOptions& options_;
  CheckFolders folders_ = checkFolders();
  std::vector<fs::path> sources_;
};

const Manifest& exerciseOf(const std::vector<Manifest>& course, const CheckOptions& options) {
  if (!options.topic.empty()) return findExercise(course, options.topic);
  return findExercise(course, fs::path(options.file).stem().string());
}

int checkOne(const std::vector<Manifest>& course, const CheckOptions& options) {
  const Manifest& exercise = exerciseOf(course, options);
  if (!options.file.empty() && exercise.files.size() > 1) {
    throw std::invalid_argument(
        fmt::format("{} has {} files; --file takes the place of one only", exercise.topic, exercise.files.size()));
  }
  if (!Check(exercise, options).run()) return 1;
  const auto position = &exercise - course.data();
  const bool isLast = static_cast<std::size_t>(position) + 1 == course.size();
  if (options.file.empty() && !isLast) {
    fmt::print("{} ./muelle check {}\n", bold("next:"), course[static_cast<std::size_t>(position) + 1].topic);
  }
  return 0;
}

/// In course order, up to the first exercise with something to mend (or through all of them).
int checkCourse(const std::vector<Manifest>& course, const CheckOptions& options) {
  if (course.empty()) throw std::runtime_error("there are no exercises");
  const auto unfinished = unfinishedExercises(build_paths::binary);
  bool allPass = true;
  for (const Manifest& exercise : course) {
    if (unfinished.contains(exercise.topic)) continue;
    allPass = Check(exercise, options).run() && allPass;
    if (!allPass && !options.all) break;
  }
  if (allPass)
    fmt::print("\nEvery public test of the course passes. Hidden tests ask for more: read the contracts again.\n");
  return allPass ? 0 : 1;
}

/// A manifest that cannot be read may be one that was changed: then that is said first.
std::vector<Manifest> readHandedOutCourse() {
  try {
    return readCourse(checkFolders().exercises);
  } catch (const std::exception&) {
    fmt::print("{}", sayChanged(build_paths::source));
    std::fflush(stdout);
    throw;
  }
}

int check(const CheckOptions& options) {
  const std::vector<Manifest> course = readHandedOutCourse();
  const bool isOne = !options.topic.empty() || !options.file.empty();
  return isOne ? checkOne(course, options) : checkCourse(course, options);
}

}  // namespace

void addCheck(CommandLine& program) {
  const auto options = std::make_shared<CheckOptions>();
  CommandLine& command = program.command("check", "Compile your file, run the public tests, draw the curves");
  const CommandLineOption topic = command.option(
      "EXERCISE", options->topic, "Which exercise; without it, the first in course order with something to mend");
  command.option("--file", options->file, "Check this file instead of exercises/EXERCISE/EXERCISE.cpp");
  command.option("--predict", options->predict,
                 "What you expect of the curve, where the exercise asks: an answer or its number");
  command.flag("--no-plot", options->noPlot, "Draw no curves");
  command.flag("--all", options->all, "Go on to the other exercises when one fails").excludes(topic);
  command.footer(
      "Exit code: 0 when all public tests pass, 1 while something fails.\nExample: ./muelle check spring_1d");
  command.action([options] { return check(*options); });
}

}  // namespace muelle::app
