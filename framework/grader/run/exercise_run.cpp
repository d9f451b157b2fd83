#include "grader/run/exercise_run.h"

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
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  graded_.build = built.object.outcome;
  if (graded_.build.status != Status::Built) {
    grader_.count(grader_.finished_);
    return done_(std::move(graded_));
  }
  candidate_ = std::make_unique<Candidate>(
      Candidate{manifest_, sources_, objectKey(grader_.workplace(), manifest_, sources_, grader_.options().sandbox),
                built.object});
  missing_ = manifest_.criteria.size() + (grader_.options().withCurves ? 1 : 0);
  grader_.count(grader_.known_, static_cast<int>(missing_));
  grader_.count(grader_.finished_);
  if (grader_.options().withCurves) pool_.prepend([self = shared_from_this()] { self->draw(); });
  for (std::size_t i = manifest_.criteria.size(); i-- > 0;) {
    pool_.prepend([self = shared_from_this(), i] { self->judge(i, Try::Shared); });
  }
}

std::string ExerciseRun::timedOutIn(const std::map<std::string, std::string>& suites, const Criterion& criterion,
                                    std::string& function) const {
  const auto find = [&](const std::string& name) {
    const auto found = suites.find(name);
    if (found == suites.end()) return false;
    function = name;
    return true;
  };
  if (find(Session::loading)) return suites.at(function);
  return std::any_of(criterion.functions.begin(), criterion.functions.end(), find) ? suites.at(function) : "";
}

Verdict ExerciseRun::withoutTrying(const Criterion& criterion, const std::string& function,
                                   const std::string& suite) const {
  Verdict verdict;
  verdict.topic = manifest_.topic;
  verdict.suite = criterion.suite;
  verdict.outcome = Outcome::Cpu;
  verdict.fault =
      function == Session::loading
          ? "the code that runs when your file is loaded does not end"
          : fmt::format("{} did not return in time in criterion {}; this criterion needs it", function, suite);
  return verdict;
}

std::optional<Verdict> ExerciseRun::known(const Criterion& criterion, Try attempt) {
  if (!grader_.options().fresh) {
    auto kept = keptVerdict(grader_.workplace(), grader_.records(), *candidate_, criterion, grader_.options());
    if (kept) return kept;
  }
  if (attempt == Try::Shared) return std::nullopt;
  const std::lock_guard lock(mutex_);
  std::string function;
  const std::string suite = timedOutIn(confirmed_, criterion, function);
  if (suite.empty()) return std::nullopt;
  return withoutTrying(criterion, function, suite);
}

void ExerciseRun::judge(std::size_t index, Try attempt) {
  const Criterion& criterion = manifest_.criteria[index];
  if (auto verdict = known(criterion, attempt)) return settle(criterion, std::move(*verdict));
  const auto tryAlone = [&] { pool_.addAlone([self = shared_from_this(), index] { self->judge(index, Try::Alone); }); };
  if (attempt == Try::Shared) {
    const std::lock_guard lock(mutex_);
    std::string function;
    if (!timedOutIn(suspected_, criterion, function).empty()) return tryAlone();
  }
  ++grader_.started_;
  Verdict verdict = judgeCriterion(grader_.workplace(), grader_.records(), *candidate_, criterion, grader_.options());
  if (isDoubtful(verdict) && attempt == Try::Shared) {
    const std::lock_guard lock(mutex_);
    if (!verdict.timedOut.empty()) suspected_.emplace(verdict.timedOut, criterion.suite);
    return tryAlone();
  }
  settle(criterion, std::move(verdict));
}

/// A limit of processor time that was passed with nothing else running is the submission's: kept. What was killed, or
/// passed a wide limit of wall time, is the machine's: not kept, so that the next run tries again.
void ExerciseRun::settle(const Criterion& criterion, Verdict verdict) {
  if (verdict.outcome == Outcome::Cpu && verdict.graderFault.empty()) {
    try {
      keepVerdict(grader_.workplace(), grader_.records(), *candidate_, criterion, grader_.options(), verdict);
    } catch (const std::exception& error) {
      verdict.graderFault = error.what();
    }
  }
  {
    const std::lock_guard lock(mutex_);
    if (!verdict.timedOut.empty()) confirmed_.emplace(verdict.timedOut, criterion.suite);
    graded_.verdicts.insert_or_assign(criterion.suite, std::move(verdict));
  }
  finishPart();
}

void ExerciseRun::draw() {
  const Workplace& workplace = grader_.workplace();
  std::optional<Curves> curves;
  if (!grader_.options().fresh) curves = keptCurves(workplace, grader_.records(), *candidate_, grader_.options());
  if (!curves) {
    ++grader_.started_;
    curves = drawCurves(workplace, grader_.records(), *candidate_, grader_.options());
  }
  {
    const std::lock_guard lock(mutex_);
    graded_.figures = std::move(curves->svgs);
    graded_.figuresNote = std::move(curves->note);
  }
  finishPart();
}

void ExerciseRun::finishPart() {
  grader_.count(grader_.finished_);
  std::unique_lock lock(mutex_);
  if (--missing_ > 0) return;
  lock.unlock();
  done_(std::move(graded_));
}

}  // namespace muelle::grader
