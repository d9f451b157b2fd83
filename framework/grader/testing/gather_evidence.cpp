#include "grader/testing/gather_evidence.h"

#include "course/testing/never_written.h"
#include "grader/testing/features.h"
#include "grader/testing/generic_mistakes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::grader {

namespace {

using Numbers = CallHistoryBase::Numbers;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double precise = 1e-9;  ///< a relative deviation that round-off explains
constexpr double near = 1e-3;     ///< and one of a method or a type that is not exact

/// Largest difference of two answers, relative to the right one; infinity where they cannot be compared. Where the
/// right one cancels to little, as k (L - L0) at rest, round-off is that of the numbers that it is made of.
double deviationOf(const Numbers& got, const Numbers& expected, double floor) {
  constexpr double cancelled = 1e6;
  if (got.size() != expected.size()) return infinite;
  const double scale = scaleOf(expected) + cancelled * floor;
  double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (got[i] == expected[i]) continue;
    const double deviation = std::abs(got[i] - expected[i]) / scale;
    worst = std::isfinite(deviation) ? std::max(worst, deviation) : infinite;
  }
  return worst;
}

/// Widens the range of a feature by one more call.
void widen(std::map<Feature, FeatureRange>& features, FeatureValue each, bool isRight, bool isPlain) {
  const FeatureRange none{infinite, -infinite, infinite, -infinite, infinite, -infinite};
  FeatureRange& range = features.try_emplace(std::move(each.feature), none).first->second;
  double& fewest = isRight ? range.fewestRight : range.fewestWrong;
  double& most = isRight ? range.mostRight : range.mostWrong;
  fewest = std::min(fewest, each.value);
  most = std::max(most, each.value);
  if (!isRight || !isPlain) return;
  range.fewestPlain = std::min(range.fewestPlain, each.value);
  range.mostPlain = std::max(range.mostPlain, each.value);
}

class Gatherer {
 public:
  explicit Gatherer(const CallHistoryBase& history) : history_(history) {
    for (std::size_t call = 0; call < history.calls(); ++call) count(call);
    found_.isConstant = isConstant();
    for (const Prediction& each : predictionsOf(history)) addIfAgrees(each);
  }

  FunctionEvidence take() { return std::move(found_); }

 private:
  void count(std::size_t call) {
    const Numbers& got = history_.outcome(call);
    const Numbers expected = history_.oracle(call);
    const double floor = history_.roundOff(call);
    const bool isRight = agree(got, expected, floor);
    const bool isZero = std::ranges::all_of(got, [](double number) { return number == 0; });
    const bool isFinite = std::ranges::all_of(got, [](double number) { return std::isfinite(number); });
    const double deviation = deviationOf(got, expected, floor);
    ++found_.calls;
    found_.zero += isZero ? 1 : 0;
    found_.wrong += isRight ? 0 : 1;
    found_.wrongZero += !isRight && isZero ? 1 : 0;
    found_.notANumber += !isRight && !isFinite ? 1 : 0;
    found_.isUnwritten = found_.isUnwritten || std::ranges::any_of(got, isFill);
    if (deviation > precise && deviation <= near) {
      ++found_.imprecise;
      found_.worstNear = std::max(found_.worstNear, deviation);
    }
    std::vector<FeatureValue> features = featuresOf(history_.items(call));
    const bool isPlain = std::ranges::none_of(features, isNothing);
    found_.plainRight += isRight && isPlain ? 1 : 0;
    for (FeatureValue& each : features) widen(found_.features, std::move(each), isRight, isPlain);
  }

  static bool isNothing(const FeatureValue& each) { return each.feature.kind != "count" && each.value == 0; }

  bool isConstant() const {
    bool differs = false;
    for (std::size_t call = 1; call < history_.calls(); ++call) {
      if (history_.outcome(call) != history_.outcome(0)) return false;
      differs = differs || history_.oracle(call) != history_.oracle(0);
    }
    return differs;
  }

  void addIfAgrees(const Prediction& prediction) {
    Hypothesis hypothesis = prediction.hypothesis;
    for (std::size_t call = 0; call < history_.calls(); ++call) {
      const Numbers& got = history_.outcome(call);
      const Numbers numbers = prediction.numbers(call);
      const double floor = history_.roundOff(call);
      if (!agree(got, numbers, floor)) return;
      const bool isExact = got == numbers || hasNoNumber(got) || deviationOf(got, numbers, floor) <= precise;
      hypothesis.isExact = hypothesis.isExact && isExact;
    }
    found_.agreeing.push_back(std::move(hypothesis));
  }

  static bool hasNoNumber(const Numbers& numbers) {
    return std::ranges::any_of(numbers, [](double number) { return !std::isfinite(number); });
  }

  const CallHistoryBase& history_;
  FunctionEvidence found_;
};

}  // namespace

FunctionEvidence gatherEvidence(const CallHistoryBase& history) {
  if (!history.hasOracle() || history.calls() == 0) return {};
  return Gatherer(history).take();
}

}  // namespace muelle::grader
