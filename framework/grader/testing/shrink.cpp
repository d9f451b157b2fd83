#include "grader/testing/shrink.h"

#include "grader/testing/generic_mistakes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace muelle::grader {

namespace {

using Kind = ArgumentItem::Kind;
using Numbers = std::vector<double>;

constexpr int mostPasses = 3;
constexpr int mostQuestions = 400;
/// Answers further apart than this are seen to differ in what is printed.
constexpr double visible = 1e-4;

/// What a number may become, the simplest first.
constexpr double simpleNumbers[] = {0, 1, 2, 3, -1, -2, 10};

double rounded(double number, int digits) {
  if (number == 0 || !std::isfinite(number)) return number;
  return std::stod(fmt::format("{:.{}g}", number, digits));  // 0.6, not 6 times 0.1
}

bool isUnit(const Numbers& numbers) {
  double square = 0;
  for (const double number : numbers) square += number * number;
  return std::abs(square - 1) < 1e-9;
}

class Shrinker {
 public:
  Shrinker(const std::string& function, CallHistoryBase& history, std::string_view contract)
      : history_(history),
        asked_(history.calls()),
        parameters_(parametersOf(contract, function)),
        ranges_(rangesOf(contract)) {}

  std::optional<std::size_t> run() {
    const auto first = firstWrong();
    if (!first) return std::nullopt;
    base_ = *first;
    mustBeVisible_ = isVisible(base_);
    if (!isConstant()) {
      for (const Prediction& each : predictionsOf(history_)) remember(each.numbers);
    }
    for (int pass = 0; pass < mostPasses; ++pass) {
      const std::size_t before = base_;
      shrinkAll(pass > 0);
      if (base_ == before) break;
    }
    return base_;
  }

 private:
  using Predicted = std::function<Numbers(std::size_t)>;

  bool isWrong(std::size_t call) const {
    return !agree(history_.outcome(call), history_.oracle(call), history_.roundOff(call));
  }

  bool isVisible(std::size_t call) const {
    const Numbers& got = history_.outcome(call);
    const Numbers expected = history_.oracle(call);
    if (got.size() != expected.size()) return true;
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (!(std::abs(got[i] - expected[i]) <= visible * std::max(1.0, scaleOf(expected)))) return true;
    }
    return false;
  }

  std::optional<std::size_t> firstWrong() const {
    std::optional<std::size_t> found;
    for (std::size_t call = 0; call < asked_; ++call) {
      if (!isWrong(call)) continue;
      if (isVisible(call)) return call;
      if (!found) found = call;
    }
    return found;
  }

  /// What always answers the same is told to do that: where a hypothesis agrees, it does so by chance.
  bool isConstant() const {
    for (std::size_t call = 1; call < asked_; ++call) {
      if (history_.outcome(call) != history_.outcome(0)) return false;
    }
    return asked_ > 1;
  }

  /// Of the hypotheses those count that explain all calls.
  void remember(const Predicted& predicted) {
    for (std::size_t call = 0; call < asked_; ++call) {
      if (!agree(history_.outcome(call), predicted(call), history_.roundOff(call))) return;
    }
    agreeing_.push_back(predicted);
  }

  /// \param isLate what was tried first has left numbers of many digits, perhaps
  void shrinkAll(bool isLate) {
    const std::vector<ArgumentItem> items = history_.items(base_);
    for (const ArgumentItem& item : items) {
      if (item.kind == Kind::List) shrinkList(item.leaf);
    }
    shrinkPlaces(isLate);
    for (const ArgumentItem& item : items) {
      if (item.kind == Kind::Number || item.kind == Kind::Field) shrinkNumber(item.leaf);
      if (item.kind == Kind::Vector) shrinkVector(item);
      if (item.kind == Kind::Stack) shrinkComponents(item);
    }
  }

  /// Two places near each other, 1 and 1 + 2^-30, lose what is between them when one alone changes: both are moved
  /// until the one lies at the origin. Late, any two vectors are tried, a node on a sphere and its centre.
  void shrinkPlaces(bool isLate) {
    const std::vector<ArgumentItem> items = history_.items(base_);
    for (auto last = items.rbegin(); last != items.rend(); ++last) {
      const ArgumentItem& origin = *last;
      if (std::ranges::all_of(origin.numbers, [](double number) { return number == 0; })) continue;
      for (const ArgumentItem& place : items) {
        const bool areVectors = place.kind == Kind::Vector && origin.kind == Kind::Vector &&
                                place.numbers.size() == origin.numbers.size() && place.numbers.size() <= mostComponents;
        if (place.kind == Kind::List || place.leaf == origin.leaf) continue;
        if (!areNear(place.numbers, origin.numbers) && !(isLate && areVectors)) continue;
        if (attempt(movedBy(origin.numbers, place.leaf), movedBy(origin.numbers, origin.leaf))) return;
      }
    }
  }

  static bool areNear(const Numbers& a, const Numbers& b) {
    if (a.size() != b.size() || a.size() > mostComponents) return false;
    double distance = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      distance = std::max(distance, std::abs(a[i] - b[i]));
      size = std::max(size, std::abs(b[i]));
    }
    return distance < 1e-2 * size;
  }

  static Edit movedBy(const Numbers& way, const Leaf& leaf) {
    return {leaf, [way, i = std::size_t{0}](double number) mutable { return number - way[i++ % way.size()]; }};
  }

  void shrinkList(const Leaf& leaf) {
    for (const Part part : {Part::First, Part::WithoutFirst, Part::WithoutLast}) {
      while (sizeOf(leaf) > 1 && attempt({leaf, {}, part})) {
      }
    }
  }

  double sizeOf(const Leaf& leaf) const {
    for (const ArgumentItem& item : history_.items(base_)) {
      if (item.kind == Kind::List && item.leaf == leaf) return item.numbers.front();
    }
    return 0.0;
  }

  /// Those of a call; a list of numbers has the place of its length.
  Numbers numbersAt(const Leaf& leaf, std::size_t call) const {
    for (ArgumentItem& item : history_.items(call)) {
      if (item.kind == Kind::List || item.leaf != Leaf{leaf.argument, leaf.field, -1}) continue;
      return leaf.component < 0 ? item.numbers : Numbers{item.numbers[static_cast<std::size_t>(leaf.component)]};
    }
    return {};
  }
  Numbers numbersAt(const Leaf& leaf) const { return numbersAt(leaf, base_); }

  void shrinkNumber(const Leaf& leaf) {
    for (const double simple : simpleNumbers) {
      if (isAlready(leaf, simple) ||
          (isAllowed(leaf, simple) && attempt({leaf, [simple](double) { return simple; }}))) {
        return;
      }
    }
    for (const int digits : {1, 2}) {
      const Numbers now = numbersAt(leaf);
      const auto change = [digits](double number) { return rounded(number, digits); };
      const bool changes = std::ranges::any_of(now, [&](double number) { return change(number) != number; });
      if (!changes || attempt({leaf, change})) return;
    }
  }

  bool isAlready(const Leaf& leaf, double simple) const {
    return std::ranges::all_of(numbersAt(leaf), [simple](double number) { return number == simple; });
  }

  void shrinkVector(const ArgumentItem& item) {
    if (isAlwaysUnit(item.leaf)) return shrinkDirection(item.leaf);
    const bool isPoint = item.numbers.size() <= mostComponents;
    if (isPoint && attempt({item.leaf, [](double) { return 0.0; }})) return;
    shrinkComponents(item);
  }

  void shrinkComponents(const ArgumentItem& item) {
    for (std::size_t i = 0; i < item.numbers.size(); ++i) {
      shrinkNumber({item.leaf.argument, item.leaf.field, static_cast<int>(i)});
    }
  }

  /// A unit vector becomes an axis, or else one of few digits.
  void shrinkDirection(const Leaf& leaf) {
    for (const double along : {1.0, -1.0}) {
      for (const int axis : {2, 0, 1}) {
        Numbers unit{0, 0, 0};
        unit[static_cast<std::size_t>(axis)] = along;
        if (becomes(leaf, unit)) return;
      }
    }
    for (Numbers sizes : {Numbers{0, 0.6, 0.8}, Numbers{0.48, 0.6, 0.64}, Numbers{0.36, 0.48, 0.8}}) {
      do {
        if (becomes(leaf, signedAs(numbersAt(leaf), sizes))) return;
      } while (std::ranges::next_permutation(sizes).found);
    }
  }

  static Numbers signedAs(const Numbers& numbers, Numbers sizes) {
    for (std::size_t i = 0; i < sizes.size() && i < numbers.size(); ++i) sizes[i] = std::copysign(sizes[i], numbers[i]);
    return sizes;
  }

  /// Whether a vector is `numbers`, or may become that.
  bool becomes(const Leaf& leaf, const Numbers& numbers) {
    const Numbers now = numbersAt(leaf);
    if (now.size() != numbers.size()) return false;
    std::size_t component = 0;
    return now == numbers || attempt({leaf, [&](double) { return numbers[component++]; }});
  }

  /// A vector that has length 1 in all calls is a direction: the contract asks for that.
  bool isAlwaysUnit(const Leaf& leaf) const {
    for (std::size_t call = 0; call < asked_; ++call) {
      for (const ArgumentItem& item : history_.items(call)) {
        if (item.leaf == leaf && !isUnit(item.numbers)) return false;
      }
    }
    return true;
  }

  /// Within the contract's range, where it has one. That of a list of numbers is about its length: where all numbers
  /// that it was asked with are positive, masses perhaps, others are not passed.
  bool isAllowed(const Leaf& leaf, double number) const {
    const auto index = static_cast<std::size_t>(leaf.argument);
    if (index >= parameters_.size() || leaf.component >= 0) return true;
    if (isListOfNumbers(leaf)) return number > 0 || !isAlwaysPositive(leaf);
    const Parameter& parameter = parameters_[index];
    const auto field = static_cast<std::size_t>(leaf.field);
    const bool isField = leaf.field >= 0 && field < parameter.fields.size();
    const std::string& name = isField ? parameter.fields[field] : parameter.name;
    const auto range = std::ranges::find(ranges_, name, &Range::name);
    return range == ranges_.end() || (range->least <= number && number <= range->most);
  }

  bool isListOfNumbers(const Leaf& leaf) const {
    return std::ranges::any_of(history_.items(base_),
                               [&](const ArgumentItem& item) { return item.kind == Kind::List && item.leaf == leaf; });
  }

  bool isAlwaysPositive(const Leaf& leaf) const {
    for (std::size_t call = 0; call < asked_; ++call) {
      if (std::ranges::any_of(numbersAt(leaf, call), [](double number) { return number <= 0; })) return false;
    }
    return true;
  }

  /// Asks; keeps the edited call as the new base when it shows the same mistake.
  bool attempt(const Edit& edit) {
    const std::size_t before = history_.calls();
    return ask(base_, edit) && keepsOrForgets(before);
  }

  /// The same for two changes at once.
  bool attempt(const Edit& first, const Edit& second) {
    const std::size_t before = history_.calls();
    if (!ask(base_, first)) return false;
    if (ask(before, second) && keepsOrForgets(before + 1)) return true;
    history_.keepOnly(before);
    return false;
  }

  bool ask(std::size_t call, const Edit& edit) {
    if (questions_++ >= mostQuestions) return false;
    const std::size_t before = history_.calls();
    history_.ask(call, edit);
    return history_.calls() > before;
  }

  bool keepsOrForgets(std::size_t call) {
    if (showsTheSame(call)) {
      base_ = call;
      return true;
    }
    history_.keepOnly(call);
    return false;
  }

  bool showsTheSame(std::size_t call) const {
    const Numbers expected = history_.oracle(call);
    const bool isFinite = std::ranges::all_of(expected, [](double number) { return std::isfinite(number); });
    if (!isFinite || !isWrong(call) || (mustBeVisible_ && !isVisible(call))) return false;
    return std::ranges::all_of(agreeing_, [&](const Predicted& predicted) {
      return agree(history_.outcome(call), predicted(call), history_.roundOff(call));
    });
  }

  CallHistoryBase& history_;
  std::size_t asked_;
  std::vector<Parameter> parameters_;
  std::vector<Range> ranges_;
  std::vector<Predicted> agreeing_;
  std::size_t base_ = 0;
  bool mustBeVisible_ = true;
  int questions_ = 0;
};

}  // namespace

std::optional<CounterExample> simplestCounterExample(const std::string& function, CallHistoryBase& history,
                                                     std::string_view contract) {
  if (!history.hasOracle()) return std::nullopt;
  const std::size_t asked = history.calls();
  const std::optional<std::size_t> found = Shrinker(function, history, contract).run();
  std::optional<CounterExample> example;
  if (found) {
    example = CounterExample{function, history.argumentTexts(*found), history.outcome(*found), history.oracle(*found),
                             history.answersTrueOrFalse()};
  }
  history.keepOnly(asked);
  return example;
}

}  // namespace muelle::grader
