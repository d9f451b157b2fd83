#include "grader/run/grade.h"

#include "base/file.h"
#include "grader/record.h"
#include "grader/run/time_out_marks.h"

#include <fmt/format.h>
#include <cstdlib>
#include <random>

namespace muelle::grader {

namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

const Sources* GradingJob::sources(const Manifest& manifest) const {
  const auto found = submission.sources.find(manifest.topic);
  if (found == submission.sources.end() || found->second.size() != manifest.files.size()) return nullptr;
  return &found->second;
}

GradingJob openJob(const Workplace& workplace, const std::filesystem::path& submission, GradeOptions options) {
  GradingJob job;
  job.workplace = workplace;
  job.course = readCourse(workplace.exercises());
  job.submission = takeSubmission(submission, job.course);
  job.options = std::move(options);
  if (job.options.seed.empty()) job.options.seed = keptSeed(workplace);
  return job;
}

std::string keptSeed(const Workplace& workplace) {
  const std::filesystem::path file = workplace.seedFile();
  if (!std::filesystem::exists(file)) {
    std::random_device device;
    std::filesystem::create_directories(file.parent_path());
    writeFile(file, fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device()));
  }
  return readFile(file);
}

GradingJob jobFromEnvironment(const Workplace& workplace) {
  const std::string submission = environment("MUELLE_SUBMISSION");
  if (submission.empty()) {
    throw std::runtime_error(
        "MUELLE_SUBMISSION is not set: name the folder or archive to grade, as in "
        "MUELLE_SUBMISSION=solutions ctest --preset grade");
  }
  GradeOptions options;
  options.seed = environment("MUELLE_SEED");
  options.sandbox = parseSandboxChoice(environment("MUELLE_SANDBOX"));
  return openJob(workplace, submission, options);
}

bool isComplete(const GradingJob& job) {
  for (const Manifest& manifest : job.course) {
    const Sources* sources = job.sources(manifest);
    if (sources == nullptr) continue;
    const std::string worker = workerKey(job.workplace, manifest, *sources);
    const auto build = readBuildOutcome(job.workplace, worker);
    if (!build || build->status == BuildOutcome::Status::GraderFault) return false;
    if (build->status != BuildOutcome::Status::Built) continue;
    for (const Criterion& criterion : manifest.criteria) {
      const std::string key = verdictKey(job.workplace, manifest, criterion.suite, worker, job.options);
      if (!keptVerdict(job.workplace, key)) return false;
    }
    if (!keptCurves(job.workplace, manifest, worker, job.options)) return false;
  }
  return true;
}

void forget(const GradingJob& job) {
  for (const Manifest& manifest : job.course) {
    const Sources* sources = job.sources(manifest);
    if (sources == nullptr) continue;
    const std::string worker = workerKey(job.workplace, manifest, *sources);
    for (const Criterion& criterion : manifest.criteria) {
      forgetVerdict(job.workplace, verdictKey(job.workplace, manifest, criterion.suite, worker, job.options));
    }
    forgetVerdict(job.workplace, curvesKey(job.workplace, manifest, worker, job.options));
    std::filesystem::remove_all(workerFolder(job.workplace, worker));
  }
}

}  // namespace muelle::grader
