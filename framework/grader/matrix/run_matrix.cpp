#include "grader/matrix/matrix.h"

#include "grader/run/grade.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace muelle::grader {

namespace {

using Status = BuildOutcome::Status;
using Task = std::function<void()>;

/// What the workers of one run share.
struct Run {
  const Workplace& workplace;
  const MatrixOptions& options;
  const Sandbox& sandbox;
};

void gradeRow(const Run& run, const Manifest& manifest, MatrixRow& row) {
  const BuildOutcome build = buildWorker(run.workplace, manifest, row.sources, run.sandbox);
  if (build.status != Status::Built) {
    row.trouble = build.message;
    return;
  }
  const std::string worker = workerKey(run.workplace, manifest, row.sources);
  GradedExercise graded;
  graded.manifest = manifest;
  graded.build = build;
  for (const Criterion& criterion : manifest.criteria) {
    const Verdict verdict = runCriterion(run.workplace, manifest, criterion, worker, run.options.grading);
    if (!verdict.graderFault.empty()) row.trouble = criterion.suite + ": " + verdict.graderFault;
    if (!verdict.passed()) row.lost.insert(criterion.suite);
    for (const NamedMistake& mistake : verdict.misconceptions) row.named.insert(mistake.id);
    graded.verdicts.emplace(criterion.suite, verdict);
  }
  row.points = score(graded);
}

/// Criteria of an exercise, those that have killed most mutants first.
class KillOrder {
 public:
  explicit KillOrder(const Manifest& manifest) : kills_(manifest.criteria.size(), 0) {}

  std::vector<std::size_t> order() {
    const std::lock_guard lock(mutex_);
    std::vector<std::size_t> indices(kills_.size());
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
    std::stable_sort(indices.begin(), indices.end(), [this](auto a, auto b) { return kills_[a] > kills_[b]; });
    return indices;
  }

  void addKill(std::size_t criterion) {
    const std::lock_guard lock(mutex_);
    ++kills_[criterion];
  }

 private:
  std::mutex mutex_;
  std::vector<int> kills_;
};

void gradeMutant(const Run& run, const Manifest& manifest, const Sources& solution, KillOrder& killOrder,
                 Mutant& mutant) {
  const std::string& name = manifest.files.front();
  Sources sources = solution;
  sources[name] = mutated(solution.at(name), mutant.mutation);
  const BuildOutcome build = buildWorker(run.workplace, manifest, sources, run.sandbox);
  if (build.status == Status::GraderFault) mutant.trouble = build.message;
  if (build.status != Status::Built) {
    mutant.fate = Mutant::Fate::NotCompilable;
    return;
  }
  const std::string worker = workerKey(run.workplace, manifest, sources);
  for (const std::size_t i : killOrder.order()) {  // an earlier run may have tried them in another order
    const std::string& suite = manifest.criteria[i].suite;
    const auto kept =
        keptVerdict(run.workplace, verdictKey(run.workplace, manifest, suite, worker, run.options.grading));
    if (!kept || kept->passed() || run.options.grading.fresh) continue;
    mutant.fate = Mutant::Fate::Killed;
    mutant.killer = suite;
    killOrder.addKill(i);
    return;
  }
  for (const std::size_t i : killOrder.order()) {
    const Criterion& criterion = manifest.criteria[i];
    const Verdict verdict = runCriterion(run.workplace, manifest, criterion, worker, run.options.grading);
    if (!verdict.graderFault.empty()) {
      mutant.trouble = criterion.suite + ": " + verdict.graderFault;
      return;
    }
    if (!verdict.passed()) {
      mutant.fate = Mutant::Fate::Killed;
      mutant.killer = criterion.suite;
      killOrder.addKill(i);
      return;
    }
  }
}

/// Runs tasks in several threads; the first exception ends them all and is thrown on.
void runTasks(const std::vector<Task>& tasks, int jobs, const MatrixListener& progress) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t done = 0;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      try {
        tasks[i]();
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = tasks.size();
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(static_cast<double>(done) / static_cast<double>(tasks.size()));
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

void runMatrix(const Workplace& workplace, std::vector<TopicMatrix>& matrices, const MatrixOptions& options,
               const MatrixListener& progress) {
  const auto sandbox = makeSandbox(options.grading.sandbox);
  MatrixOptions settled = options;
  settled.grading.sandbox = sandbox->choice();
  const Run run{workplace, settled, *sandbox};
  std::vector<Task> tasks;
  std::vector<std::unique_ptr<KillOrder>> killOrders;
  for (TopicMatrix& matrix : matrices) {
    for (MatrixRow& row : matrix.rows)
      tasks.emplace_back([&run, &matrix, &row] { gradeRow(run, matrix.manifest, row); });
  }
  for (TopicMatrix& matrix : matrices) {
    killOrders.push_back(std::make_unique<KillOrder>(matrix.manifest));
    KillOrder& killOrder = *killOrders.back();
    const Sources& solution = matrix.rows.front().sources;
    for (Mutant& mutant : matrix.mutants) {
      tasks.emplace_back([&run, &matrix, &solution, &killOrder, &mutant] {
        gradeMutant(run, matrix.manifest, solution, killOrder, mutant);
      });
    }
  }
  runTasks(tasks, options.jobs, progress);
}

}  // namespace muelle::grader
