/// \file
/// What each test of `ctest --preset grade` runs: one step of grading the submission named in MUELLE_SUBMISSION.
///
///     muelle-grade-step build TOPIC
///     muelle-grade-step criterion TOPIC SUITE
///     muelle-grade-step curves TOPIC
///     muelle-grade-step ctest-file FILE
///
/// The exit status tells CTest and a reader of its log; points come from the records alone.

#include "base/file.h"
#include "grader/record.h"
#include "grader/run/grade.h"

#include <fmt/format.h>
#include <algorithm>
#include <iostream>

namespace {

using namespace muelle::grader;
using muelle::Criterion;
using muelle::Manifest;
using muelle::writeFile;

constexpr int passed = 0;
constexpr int failed = 1;
constexpr int graderAtFault = 2;

const Sources& sourcesOf(const GradingJob& job, const Manifest& manifest) {
  const Sources* sources = job.sources(manifest);
  if (sources != nullptr) return *sources;
  throw std::runtime_error(fmt::format("the submission has no {}", manifest.files.front()));
}

int build(const GradingJob& job, const Manifest& manifest) {
  const auto sandbox = makeSandbox(job.options.sandbox);
  const BuildOutcome outcome = buildWorker(job.workplace, manifest, sourcesOf(job, manifest), *sandbox);
  if (outcome.status == BuildOutcome::Status::Built) return passed;
  std::cout << outcome.message << '\n' << outcome.diagnostics;
  return outcome.status == BuildOutcome::Status::GraderFault ? graderAtFault : failed;
}

int criterion(const GradingJob& job, const Manifest& manifest, const std::string& suite) {
  const auto found = std::find_if(manifest.criteria.begin(), manifest.criteria.end(),
                                  [&suite](const Criterion& entry) { return entry.suite == suite; });
  if (found == manifest.criteria.end()) {
    throw std::runtime_error(fmt::format("{} has no criterion with the suite {}", manifest.topic, suite));
  }
  const std::string worker = workerKey(job.workplace, manifest, sourcesOf(job, manifest));
  GradedExercise graded;
  graded.manifest = manifest;
  graded.build.status = BuildOutcome::Status::Built;
  const Verdict verdict = runCriterion(job.workplace, manifest, *found, worker, job.options);
  graded.verdicts.emplace(suite, verdict);
  for (const std::string& line : feedback(*found, graded)) std::cout << line << '\n';
  if (!verdict.graderFault.empty()) return graderAtFault;
  return verdict.passed() ? passed : failed;
}

int curves(const GradingJob& job, const Manifest& manifest) {
  const std::string worker = workerKey(job.workplace, manifest, sourcesOf(job, manifest));
  const Curves drawn = drawCurves(job.workplace, manifest, worker, job.options);
  if (!drawn.note.empty()) std::cout << drawn.note << '\n';
  return drawn.svgs.empty() ? failed : passed;
}

int run(const std::vector<std::string>& arguments) {
  const Workplace workplace = Workplace::ofThisBuild();
  if (arguments.size() == 2 && arguments[0] == "ctest-file") {
    writeFile(arguments[1], ctestFile(workplace, muelle::readCourse(workplace.exercises())));
    return passed;
  }
  if (arguments.size() < 2) throw std::runtime_error("usage: muelle-grade-step build|criterion|curves TOPIC [SUITE]");
  const GradingJob job = jobFromEnvironment(workplace);
  const Manifest& manifest = muelle::findExercise(job.course, arguments[1]);
  if (arguments[0] == "build") return build(job, manifest);
  if (arguments[0] == "curves") return curves(job, manifest);
  if (arguments[0] == "criterion" && arguments.size() == 3) return criterion(job, manifest, arguments[2]);
  throw std::runtime_error("unknown step '" + arguments[0] + "'");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cout << "muelle: " << error.what() << '\n';
    return graderAtFault;
  }
}
