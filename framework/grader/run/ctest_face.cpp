#include "grader/run/ctest_face.h"

#include "base/file.h"
#include "base/text/printable.h"
#include "grader/run/digest.h"
#include "grader/run/grade.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* curvesName = "curves";
constexpr int parallelTasks = 2;  // CTest itself runs as many fixtures side by side as it is told

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// One run of CTest, which is the parent of all its tests: its process id and the time at which it was started.
std::string thisRun() {
  const std::string text = tryReadFile(fmt::format("/proc/{}/stat", getppid())).value_or("");
  std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
  std::string started;
  for (int field = 3; field <= 22; ++field) fields >> started;  // proc(5)
  return fmt::format("{}-{}", getppid(), started);
}

fs::path saidFile(const Workplace& workplace, const std::string& topic) {
  return workplace.kept / "ctest" / thisRun() / (topic + ".json");
}

/// What earlier runs of CTest have left.
void removeOldRuns(const Workplace& workplace) {
  constexpr auto old = std::chrono::hours(24);
  std::error_code error;
  for (fs::directory_iterator entry(workplace.kept / "ctest", error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    const auto age = fs::file_time_type::clock::now() - entry->last_write_time(gone);
    if (!gone && age > old) fs::remove_all(entry->path(), gone);
  }
}

std::string submissionOfEnvironment() {
  const std::string path = environment("MUELLE_SUBMISSION");
  if (path.empty()) {
    throw std::runtime_error(
        "MUELLE_SUBMISSION is not set: name the folder or archive to grade, as in "
        "MUELLE_SUBMISSION=solutions ctest --preset grade");
  }
  return path;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

nlohmann::json said(const std::string& text, int status) { return {{"text", text}, {"status", status}}; }

nlohmann::json saidOf(const Criterion& criterion, const GradedExercise& graded) {
  const std::optional<double> points = score(criterion, graded);
  const int failed = points ? stepFailed : graderAtFault;
  const auto verdict = graded.verdicts.find(criterion.suite);
  const bool passed = points && verdict != graded.verdicts.end() && verdict->second.passed();
  return said(joined(feedback(criterion, graded)), passed ? stepPassed : failed);
}

/// CTest shows a test's output as it is: nothing of a submission gets there but as text.
int tell(const std::string& text, int status) {
  constexpr int lines = 200;
  constexpr std::size_t bytes = 16 * 1024;
  std::cout << cutText(printableText(text), lines, bytes);
  return status;
}

std::string testEntry(const Workplace& workplace, const std::string& topic, const std::string& name,
                      const std::string& step, const std::string& fixture) {
  return fmt::format(
      "add_test([=[grade.{0}.{1}]=] [=[{2}]=] {3})\n"
      "set_tests_properties([=[grade.{0}.{1}]=] PROPERTIES LABELS \"grade;{0}\" WORKING_DIRECTORY [=[{4}]=] {5} "
      "graded_{0})\n",
      topic, name, (workplace.binary / "bin" / "muelle-grade-step").string(), step, workplace.source.string(), fixture);
}

}  // namespace

int writeCtestFile(const Workplace& workplace, const std::string& file) {
  std::string text = "# Generated from exercises/*/exercise.toml: one test per criterion of a submission.\n";
  for (const Manifest& manifest : readCourse(workplace.exercises())) {
    const std::string& topic = manifest.topic;
    // `ctest --preset` is started in the checkout, so that is where a relative MUELLE_SUBMISSION starts.
    text += testEntry(workplace, topic, "build", "grade " + topic, "FIXTURES_SETUP");
    for (const Criterion& criterion : manifest.criteria) {
      text += testEntry(workplace, topic, criterion.suite, fmt::format("read {} {}", topic, criterion.suite),
                        "FIXTURES_REQUIRED");
    }
    text += testEntry(workplace, topic, curvesName, fmt::format("read {} {}", topic, curvesName), "FIXTURES_REQUIRED");
  }
  writeFile(file, text);
  return stepPassed;
}

int gradeForCtest(const Workplace& workplace, const std::string& topic) {
  const fs::path file = saidFile(workplace, topic);
  fs::create_directories(file.parent_path());
  fs::remove(file);
  removeOldRuns(workplace);
  GradeOptions options;
  options.seed = environment("MUELLE_SEED");
  options.sandbox = parseSandboxChoice(environment("MUELLE_SANDBOX"));
  Grader grader = openGrader(workplace, options, {topic});
  const GradedSubmission submission = grade(grader, grader.take(submissionOfEnvironment()), parallelTasks);
  const GradedExercise& graded = submission.exercises.front();

  nlohmann::json document;
  for (const Criterion& criterion : graded.manifest.criteria) document[criterion.suite] = saidOf(criterion, graded);
  document[curvesName] = said(graded.figuresNote, graded.figures.empty() ? stepFailed : stepPassed);
  writeFile(file, document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  if (graded.build.status == BuildOutcome::Status::Built) return stepPassed;
  const bool ours = graded.build.status == BuildOutcome::Status::GraderFault;
  return tell(graded.build.message + '\n' + graded.build.diagnostics, ours ? graderAtFault : stepFailed);
}

int readForCtest(const Workplace& workplace, const std::string& topic, const std::string& suite) {
  const fs::path file = saidFile(workplace, topic);
  std::error_code missing;
  if (!fs::exists(file, missing)) {
    return tell(fmt::format("nothing has been said of {}: the fixture grade.{}.build did not end", topic, topic),
                graderAtFault);
  }
  const nlohmann::json document = nlohmann::json::parse(readFile(file), nullptr, false);
  if (!document.is_object() || !document.contains(suite)) {
    return tell(fmt::format("no record of {} of {}", suite, topic), graderAtFault);
  }
  return tell(document[suite].at("text").get<std::string>(), document[suite].at("status").get<int>());
}

}  // namespace muelle::grader
