#include "grader/run/follow.h"

#include "base/text/lists.h"
#include "grader/run/replaced_object.h"

#include <utility>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// What is forbidden or misuses memory is not earned in spite of anything.
bool mayFollow(const Criterion& criterion, const Verdict& failed) {
  if (criterion.follows.empty() || failed.passed() || failed.isConfirmed) return false;
  const Outcome outcome = failed.outcome;
  return outcome == Outcome::Wrong || outcome == Outcome::NeverWritten || outcome == Outcome::Crash ||
         outcome == Outcome::Cpu || outcome == Outcome::Link;
}

/// One run and its looks. What says itself that it died or ran out of time is tried once more, and then believed.
Verdict look(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
             const GradeOptions& options, const std::vector<std::string>& ownLower) {
  Verdict verdict = lookAtCriterion(place.workplace, candidate, criterion, options, ownLower);
  if (isOwnIfTwice(verdict)) verdict = lookAtCriterion(place.workplace, candidate, criterion, options, ownLower);
  return verdict;
}

bool isMachines(const Verdict& verdict) { return isDoubtful(verdict) && !isOwnIfTwice(verdict); }

/// Nothing of what that run printed or answered is shown.
Verdict undecided(const Verdict& failed) {
  Verdict verdict = failed;
  verdict.graderFault = "the run that asks what is built on a lower function did not end";
  return verdict;
}

Verdict earnedBy(Verdict run, const std::vector<std::string>& lower, const Verdict& failed) {
  run.followed = lower;
  run.output = failed.output;
  run.seconds += failed.seconds;
  run.calls += failed.calls;
  return run;
}

/// The first entry of the record of a run with the student's own lower functions names those that are of use, or
/// missing: what is built on them can be judged with the reference's in their place.
std::vector<std::string> replaceable(const Verdict& own) {
  if (own.tests.empty() || own.isConfirmed || own.outcome == Outcome::NeverWritten) return {};
  const std::string& names = own.tests.front().property;
  return names.empty() ? std::vector<std::string>() : parted(names, ",");
}

/// The candidate with the reference's functions in the place of the student's, in each object that it has.
std::optional<Candidate> withReference(const JudgingPlace& place, const Candidate& candidate,
                                       const std::vector<std::string>& functions) {
  Candidate replaced = candidate;
  const auto replace = [&](fs::path& object, Build build) {
    if (object.empty()) return true;
    const auto linked = replacedObject(place.workplace, place.objects, place.sandbox, candidate.manifest,
                                       candidate.objectKey, functions, object, build);
    object = linked.value_or("");
    return linked.has_value();
  };
  const bool isWhole = replace(replaced.object.plain, Build::Plain) &&
                       replace(replaced.object.sanitised, Build::Sanitised) &&
                       replace(replaced.object.refilled, Build::Refilled);
  return isWhole ? std::optional(std::move(replaced)) : std::nullopt;
}

Verdict followUnguarded(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
                        const GradeOptions& options, const Verdict& failed) {
  Verdict own = look(place, candidate, criterion, options, criterion.follows);
  if (isMachines(own)) return undecided(failed);
  const std::vector<std::string> lower = replaceable(own);
  if (lower.empty()) return failed;
  if (own.passed()) {
    own.tests.erase(own.tests.begin());
    return own.tests.empty() ? failed : earnedBy(std::move(own), lower, failed);
  }
  const std::optional<Candidate> replaced = withReference(place, candidate, lower);
  if (!replaced) return failed;
  Verdict right = look(place, *replaced, criterion, options, {});
  if (isMachines(right)) return undecided(failed);
  return right.passed() ? earnedBy(std::move(right), lower, failed) : failed;
}

}  // namespace

Verdict followLower(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
                    const GradeOptions& options, const Verdict& failed) {
  if (!mayFollow(criterion, failed)) return failed;
  try {
    return followUnguarded(place, candidate, criterion, options, failed);
  } catch (const std::exception& error) {
    Verdict verdict = undecided(failed);
    verdict.graderFault = error.what();
    return verdict;
  }
}

}  // namespace muelle::grader
