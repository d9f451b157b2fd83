#include "grader/run/grade.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <chrono>
#include <cstdlib>
#include <ctime>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// Long enough for the slowest class of machines; every test has shorter limits of its own.
constexpr auto ctestLimit = std::chrono::minutes(30);

int testCount(const GradingJob& job) {
  std::size_t count = 0;
  for (const Manifest& manifest : job.course) count += manifest.criteria.size() + 2;
  return static_cast<int>(count);
}

/// CTest prints one line a finished test: "12/54 Test #3: ...".
int finishedTests(const std::string& line) {
  int done = 0;
  int all = 0;
  return std::sscanf(line.c_str(), " %d/%d Test", &done, &all) == 2 ? done : 0;
}

void runCtest(const GradingJob& job, int jobs, const ProgressListener& progress) {
  Pipe out = makePipe();
  ChildSpec spec;
  spec.command = {"/usr/bin/ctest", "--test-dir", job.workplace.binary.string(), "-L",
                  "^grade$",        "-j",         std::to_string(jobs)};
  spec.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "MUELLE_SUBMISSION=" + job.submission.path.string(),
                      "MUELLE_SEED=" + job.options.seed, "MUELLE_SANDBOX=" + toText(job.options.sandbox)};
  spec.descriptors = {{1, out.write.get()}, {2, out.write.get()}};
  Child ctest(spec);
  out.write.reset();
  std::string line;
  char c = 0;
  char buffer[4096];
  ssize_t got = 0;
  while ((got = read(out.read.get(), buffer, sizeof buffer)) > 0) {
    for (ssize_t i = 0; i < got; ++i) {
      c = buffer[i];
      if (c != '\n') {
        line += c;
        continue;
      }
      if (const int done = finishedTests(line); done > 0 && progress) progress(done, testCount(job));
      line.clear();
    }
  }
  ctest.wait(std::chrono::steady_clock::now() + ctestLimit);  // its exit status says nothing: only records count
}

std::string backendDescription(SandboxChoice choice) { return settledSandbox(choice)->description(); }

GradedExercise collectExercise(const GradingJob& job, const Manifest& manifest) {
  using Status = BuildOutcome::Status;
  GradedExercise graded;
  graded.manifest = manifest;
  const Sources* sources = job.sources(manifest);
  if (sources == nullptr) {
    const auto refused = job.submission.refused.find(manifest.topic);
    const bool wasRefused = refused != job.submission.refused.end();
    graded.build = {wasRefused ? Status::Refused : Status::Missing,
                    wasRefused ? refused->second : fmt::format("the submission has no {}", manifest.files.front()), ""};
    return graded;
  }
  const std::string worker = workerKey(job.workplace, manifest, *sources);
  graded.build = readBuildOutcome(job.workplace, worker)
                     .value_or(BuildOutcome{Status::GraderFault, "the worker was never built", ""});
  if (graded.build.status != Status::Built) return graded;
  for (const Criterion& criterion : manifest.criteria) {
    const std::string key = verdictKey(job.workplace, manifest, criterion.suite, worker, job.options);
    if (auto verdict = writtenVerdict(job.workplace, key)) graded.verdicts.emplace(criterion.suite, *verdict);
  }
  const auto curves = keptCurves(job.workplace, manifest, worker, job.options);
  if (curves) graded.figures = curves->svgs;
  graded.figuresNote = curves ? curves->note : "the curves were not drawn";
  return graded;
}

}  // namespace

GradedSubmission grade(const GradingJob& job, int jobs, const ProgressListener& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (job.options.fresh) forget(job);
  if (!isComplete(job)) runCtest(job, jobs, progress);
  GradedSubmission graded = collect(job);
  graded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return graded;
}

GradedSubmission collect(const GradingJob& job) {
  GradedSubmission graded;
  graded.name = job.submission.name;
  graded.intakeNotes = job.submission.notes;
  for (const Manifest& manifest : job.course) graded.exercises.push_back(collectExercise(job, manifest));
  graded.sandbox = backendDescription(job.options.sandbox);
  graded.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return graded;
}

GradedExercise gradeExercise(const GradingJob& job, const Manifest& manifest, const Sandbox& sandbox, bool withCurves) {
  if (const Sources* sources = job.sources(manifest)) {
    const BuildOutcome build = buildWorker(job.workplace, manifest, *sources, sandbox);
    if (build.status == BuildOutcome::Status::Built) {
      const std::string worker = workerKey(job.workplace, manifest, *sources);
      for (const Criterion& criterion : manifest.criteria) {
        runCriterion(job.workplace, manifest, criterion, worker, job.options);
      }
      if (withCurves) drawCurves(job.workplace, manifest, worker, job.options);
    }
  }
  return collectExercise(job, manifest);
}

}  // namespace muelle::grader
