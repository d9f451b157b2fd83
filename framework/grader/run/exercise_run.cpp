#include "grader/run/exercise_run.h"

#include "base/file.h"
#include "grader/naming/name_mistakes.h"
#include "grader/remote/session.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

using Status = BuildOutcome::Status;

ExerciseRun::ExerciseRun(Grader& grader, Pool& pool, const Manifest& manifest, std::function<void(GradedExercise)> done)
    : grader_(grader), pool_(pool), manifest_(manifest), done_(std::move(done)) {
  graded_.manifest = manifest;
}

void ExerciseRun::begin(Sources sources) {
  sources_ = std::move(sources);
  build(Try::Shared);
}

void ExerciseRun::leaveOut(const BuildOutcome& why) {
  graded_.build = why;
  done_(std::move(graded_));
}

void ExerciseRun::fail(const std::string& what) {
  graded_.build = BuildOutcome{};
  graded_.build.status = Status::GraderFault;
  graded_.build.message = what;
  grader_.count(grader_.finished_);
  done_(std::move(graded_));
}

void ExerciseRun::build(Try attempt) {
  BuildAttempt built;
  try {
    built = buildObject(grader_.workplace(), grader_.objects(), manifest_, sources_, grader_.sandbox(),
                        grader_.options(), attempt == Try::Alone);
    if (built.wasStarted) ++grader_.started_;
    if (built.isDoubtful && attempt == Try::Shared) {
      return pool_.addAlone([self = shared_from_this()] { self->build(Try::Alone); });
    }
    candidate_ = std::make_unique<Candidate>(
        Candidate{manifest_, sources_, objectKey(grader_.workplace(), manifest_, sources_, grader_.options().sandbox),
                  built.object});
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  graded_.build = built.object.outcome;
  graded_.seed = inputSeed(manifest_, sources_, grader_.options());
  if (graded_.build.status != Status::Built) {
    grader_.count(grader_.finished_);
    return done_(std::move(graded_));
  }
  missing_ = manifest_.criteria.size() + (grader_.options().withCurves ? 1 : 0);
  grader_.count(grader_.known_, static_cast<int>(missing_));
  grader_.count(grader_.finished_);
  if (grader_.options().withCurves) pool_.prepend([self = shared_from_this()] { self->draw(); });
  for (std::size_t i = manifest_.criteria.size(); i-- > 0;) {
    pool_.prepend([self = shared_from_this(), i] { self->judge(i, Try::Shared); });
  }
}

/// What a file does when it is loaded is the same for every criterion; what a function does depends on what it is
/// asked.
Verdict ExerciseRun::asLoadingEnded(const Criterion& criterion) const {
  Verdict verdict;
  verdict.topic = manifest_.topic;
  verdict.suite = criterion.suite;
  verdict.outcome = loading_->outcome;
  verdict.fault = loading_->fault;
  return verdict;
}

std::optional<Verdict> ExerciseRun::known(const Criterion& criterion) {
  if (!grader_.options().fresh) {
    auto kept = keptVerdict(grader_.workplace(), grader_.records(), *candidate_, criterion, grader_.options());
    if (kept) return kept;
  }
  const std::lock_guard lock(mutex_);
  return loading_ ? std::optional(asLoadingEnded(criterion)) : std::nullopt;
}

void ExerciseRun::judge(std::size_t index, Try attempt) {
  const Criterion& criterion = manifest_.criteria[index];
  if (auto verdict = known(criterion)) return settle(criterion, std::move(*verdict));
  ++grader_.started_;
  Verdict verdict = judgeCriterion(grader_.judgingPlace(), *candidate_, criterion, grader_.options());
  if (attempt == Try::Shared && isDoubtful(verdict) && !isExpected(verdict)) {
    return pool_.addAlone([self = shared_from_this(), index] { self->judge(index, Try::Alone); });
  }
  settle(criterion, std::move(verdict));
}

/// A function that did not return with nothing else running is believed not to return elsewhere, either: each criterion
/// finds out for itself, but only the first one twice.
bool ExerciseRun::isExpected(const Verdict& verdict) {
  const std::lock_guard lock(mutex_);
  return verdict.outcome == Outcome::Cpu && verdict.graderFault.empty() && unreturned_.contains(verdict.timedOut);
}

/// A limit of processor time that was passed with nothing else running is the submission's, and so is a signal of which
/// its process told once more: kept. What was killed, or passed a wide limit of wall time, is the machine's: not kept,
/// so that the next run tries again.
void ExerciseRun::settle(const Criterion& criterion, Verdict verdict) {
  if (isOwnIfTwice(verdict)) {
    try {
      keepVerdict(grader_.workplace(), grader_.records(), *candidate_, criterion, grader_.options(), verdict);
    } catch (const std::exception& error) {
      verdict.graderFault = error.what();
    }
  }
  {
    const std::lock_guard lock(mutex_);
    const bool isTheFiles = verdict.graderFault.empty() && !verdict.timedOut.empty();
    if (isTheFiles && verdict.timedOut == Session::loading) loading_ = verdict;
    if (isTheFiles) unreturned_.insert(verdict.timedOut);
    graded_.verdicts.insert_or_assign(criterion.suite, std::move(verdict));
  }
  finishPart();
}

Curves ExerciseRun::curves() {
  const Workplace& workplace = grader_.workplace();
  if (!grader_.options().fresh) {
    if (auto kept = keptCurves(workplace, grader_.records(), *candidate_, grader_.options())) return *kept;
  }
  ++grader_.started_;
  return drawCurves(workplace, grader_.records(), *candidate_, grader_.options());
}

void ExerciseRun::draw() {
  Curves curves = this->curves();
  {
    const std::lock_guard lock(mutex_);
    graded_.figures = std::move(curves.svgs);
    graded_.figuresNote = std::move(curves.note);
  }
  finishPart();
}

void ExerciseRun::finishPart() {
  grader_.count(grader_.finished_);
  std::unique_lock lock(mutex_);
  if (--missing_ > 0) return;
  lock.unlock();
  nameMistakes(graded_, readFile(grader_.workplace().contract(manifest_.topic)), sources_.begin()->second);
  done_(std::move(graded_));
}

}  // namespace muelle::grader
