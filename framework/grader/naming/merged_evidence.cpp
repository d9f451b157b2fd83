#include "grader/naming/merged_evidence.h"

#include <algorithm>
#include <tuple>

namespace muelle::grader {

namespace {

void widen(FeatureRange& range, const FeatureRange& more) {
  range.fewestRight = std::min(range.fewestRight, more.fewestRight);
  range.mostRight = std::max(range.mostRight, more.mostRight);
  range.fewestPlain = std::min(range.fewestPlain, more.fewestPlain);
  range.mostPlain = std::max(range.mostPlain, more.mostPlain);
  range.fewestWrong = std::min(range.fewestWrong, more.fewestWrong);
  range.mostWrong = std::max(range.mostWrong, more.mostWrong);
}

bool isSame(const Hypothesis& a, const Hypothesis& b) {
  return std::tie(a.id, a.isListed, a.of, a.value) == std::tie(b.id, b.isListed, b.of, b.value);
}

void merge(FunctionEvidence& all, const FunctionEvidence& more) {
  all.calls += more.calls;
  all.wrong += more.wrong;
  all.imprecise += more.imprecise;
  all.worstNear = std::max(all.worstNear, more.worstNear);
  all.isUnwritten = all.isUnwritten || more.isUnwritten;
  all.notANumber += more.notANumber;
  all.zero += more.zero;
  all.wrongZero += more.wrongZero;
  all.plainRight += more.plainRight;
  all.isStateful = all.isStateful || more.isStateful;
  all.isConstant = all.isConstant && more.isConstant;
  std::erase_if(all.agreeing, [&more](Hypothesis& each) {
    const auto other = std::ranges::find_if(more.agreeing, [&each](const Hypothesis& h) { return isSame(h, each); });
    if (other == more.agreeing.end()) return true;
    each.isExact = each.isExact && other->isExact;
    return false;
  });
  for (const auto& [feature, range] : more.features) {
    const auto [known, isNew] = all.features.try_emplace(feature, range);
    if (!isNew) widen(known->second, range);
  }
}

}  // namespace

Evidence mergedEvidence(const std::map<std::string, Verdict>& verdicts) {
  Evidence merged;
  for (const auto& [suite, verdict] : verdicts) {
    // Earned with the reference's lower function in place of the student's: the answers are that one's, and what is
    // built on it.
    if (!verdict.followed.empty()) continue;
    for (const auto& [function, evidence] : verdict.evidence) {
      const auto [known, isNew] = merged.try_emplace(function, evidence);
      if (!isNew) merge(known->second, evidence);
    }
  }
  return merged;
}

}  // namespace muelle::grader
