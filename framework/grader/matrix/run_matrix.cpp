#include "grader/matrix/matrix.h"

#include "base/file.h"
#include "grader/authors/same_mistakes.h"
#include "grader/matrix/ranges.h"
#include "grader/matrix/sentences.h"
#include "grader/naming/merged_evidence.h"
#include "grader/report/example_sentence.h"
#include "grader/run/grade.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace muelle::grader {

namespace {

using Status = BuildOutcome::Status;

/// What became of a row.
void fill(MatrixRow& row, const GradedExercise& graded) {
  if (graded.build.outcome == Outcome::Forbidden) {  // refused by what it uses: lost as a whole
    for (const Criterion& criterion : graded.manifest.criteria) row.lost.insert(criterion.suite);
    return;
  }
  if (graded.build.status != Status::Built) {
    row.trouble = graded.build.message;
    return;
  }
  for (const auto& [suite, verdict] : graded.verdicts) {
    if (!verdict.graderFault.empty()) row.trouble = suite + ": " + verdict.graderFault;
    if (!verdict.passed()) row.lost.insert(suite);
    for (const NamedMistake& mistake : verdict.mistakes) row.named.insert(mistake.id);
    if (verdict.outcome == Outcome::NeverWritten) row.named.insert("never_written");
    if (verdict.examples.empty()) continue;
    ++row.examples;
    row.examplesForPaper += isForPaper(verdict.examples.front()) ? 1 : 0;
  }
  row.points = score(graded);
}

/// The solution answers every call: what it was asked is what the hidden tests pass.
void lookAtCalls(const Workplace& workplace, TopicMatrix& matrix, const GradedExercise& graded) {
  const std::string contract = readFile(workplace.contract(matrix.manifest.topic));
  matrix.endsNotPassed = endsNotPassed(contract, mergedEvidence(graded.verdicts));
  matrix.mistakesNotToldApart = mistakesNotToldApart(graded.verdicts);
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

/// One mutant, criterion by criterion until one is lost.
class MutantRun {
 public:
  MutantRun(Grader& grader, Pool& pool, const Manifest& manifest, const Sources& solution, KillOrder& killOrder,
            Mutant& mutant)
      : grader_(grader), pool_(pool), manifest_(manifest), killOrder_(killOrder), mutant_(mutant), sources_(solution) {
    const std::string& name = manifest.files.front();
    sources_[name] = mutated(solution.at(name), mutant.mutation);
  }

  /// \param isAlone believes what died or ran out of time; else that is tried again, alone
  void run(bool isAlone) {
    const BuildAttempt built = buildObject(grader_.workplace(), grader_.objects(), manifest_, sources_,
                                           grader_.sandbox(), grader_.options(), isAlone);
    if (built.isDoubtful && !isAlone) return tryAlone();
    const BuildOutcome& outcome = built.object.outcome;
    if (outcome.status == Status::GraderFault) mutant_.trouble = outcome.message;
    mutant_.fate = outcome.status == Status::Built ? Mutant::Fate::Survived : Mutant::Fate::NotCompilable;
    if (outcome.status != Status::Built) return;
    const Candidate candidate{manifest_, sources_,
                              objectKey(grader_.workplace(), manifest_, sources_, grader_.options().sandbox),
                              built.object};
    if (!isKilledAlready(candidate)) judge(candidate, isAlone);
  }

 private:
  void tryAlone() {
    pool_.addAlone([copy = *this]() mutable { copy.run(true); });
  }

  void kill(std::size_t criterion) {
    mutant_.fate = Mutant::Fate::Killed;
    mutant_.killer = manifest_.criteria[criterion].suite;
    killOrder_.addKill(criterion);
  }

  /// An earlier run may have tried the criteria in another order.
  bool isKilledAlready(const Candidate& candidate) {
    if (grader_.options().fresh) return false;
    for (const std::size_t i : killOrder_.order()) {
      const auto kept =
          keptVerdict(grader_.workplace(), grader_.records(), candidate, manifest_.criteria[i], grader_.options());
      if (!kept || kept->passed()) continue;
      kill(i);
      return true;
    }
    return false;
  }

  void judge(const Candidate& candidate, bool isAlone) {
    for (const std::size_t i : killOrder_.order()) {
      const Criterion& criterion = manifest_.criteria[i];
      const Verdict verdict = judgeCriterion(grader_.judgingPlace(), candidate, criterion, grader_.options());
      if (isDoubtful(verdict) && !isAlone) return tryAlone();
      if (!verdict.graderFault.empty()) {
        mutant_.trouble = criterion.suite + ": " + verdict.graderFault;
        return;
      }
      if (!verdict.passed()) return kill(i);
    }
  }

  Grader& grader_;
  Pool& pool_;
  const Manifest& manifest_;
  KillOrder& killOrder_;
  Mutant& mutant_;
  Sources sources_;
};

/// How much is done, for a progress bar, and what all submissions of an exercise have in common.
class Counter {
 public:
  explicit Counter(const MatrixListener& listener) : listener_(listener) {}
  void expectOne() { ++all_; }
  /// Submissions are graded side by side.
  void add(TopicMatrix& matrix, const MatrixRow& row, const GradedExercise& graded) {
    const std::lock_guard lock(mutex_);
    matrix.sentences.merge(sentencesOf(graded));
    const bool isUnnamed = row.kind == MatrixRow::Kind::Wrong && !unnamedMistakes(graded).empty();
    if (isUnnamed) matrix.unnamed.push_back({row.name, matrix.manifest, row.sources});
  }
  void count() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (listener_) listener_(static_cast<double>(done_) / all_);
  }

 private:
  const MatrixListener& listener_;
  std::mutex mutex_;
  int done_ = 0;
  int all_ = 0;
};

}  // namespace

void runMatrix(const Workplace& workplace, std::vector<TopicMatrix>& matrices, const MatrixOptions& options,
               const MatrixListener& progress) {
  GradeOptions grading = options.grading;
  grading.withCurves = false;
  Grader grader(workplace, {}, grading, makeSandbox(grading.sandbox));
  grading.forAuthors = true;
  Grader forAuthors(workplace, {}, grading, makeSandbox(grading.sandbox));
  Pool pool(options.jobs);
  Counter counter(progress);
  for (TopicMatrix& matrix : matrices) {
    for (MatrixRow& row : matrix.rows) {
      counter.expectOne();
      const bool isSolution = row.kind == MatrixRow::Kind::Solution;
      Grader& itsGrader = isSolution ? forAuthors : grader;
      itsGrader.addExercise(pool, matrix.manifest, &row.sources, {}, [&, isSolution](const GradedExercise& graded) {
        fill(row, graded);
        counter.add(matrix, row, graded);
        if (isSolution) lookAtCalls(workplace, matrix, graded);
        counter.count();
      });
    }
  }
  std::vector<std::unique_ptr<KillOrder>> killOrders;
  for (TopicMatrix& matrix : matrices) {
    killOrders.push_back(std::make_unique<KillOrder>(matrix.manifest));
    for (Mutant& mutant : matrix.mutants) {
      counter.expectOne();
      MutantRun run(grader, pool, matrix.manifest, matrix.rows.front().sources, *killOrders.back(), mutant);
      pool.append([run, &counter]() mutable {
        run.run(false);
        counter.count();
      });
    }
  }
  pool.run();
}

}  // namespace muelle::grader
