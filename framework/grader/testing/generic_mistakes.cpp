#include "grader/testing/generic_mistakes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muelle::grader {

namespace {

using Kind = ArgumentItem::Kind;
using Numbers = std::vector<double>;

/// Answers of more numbers are not looked at one by one.
constexpr std::size_t mostResults = 9;

/// What a student may write in place of an argument.
constexpr double usualConstants[] = {9.81, 9.8, 10.0, 2.0, 0.5, -1.0, 100.0, 1000.0};

class Builder {
 public:
  explicit Builder(const CallHistoryBase& history) : history_(history) {
    addListed();
    addResults(history.oracle(0).size());
    const std::vector<ArgumentItem> items = history.items(0);
    for (const ArgumentItem& item : items) addItem(item);
    for (const ArgumentItem& from : items) {
      for (const ArgumentItem& to : items) addSameField(from, to);
    }
    for (int j = 0; j < history.argumentCount(); ++j) {
      for (int i = 0; i < j; ++i) addPair(i, j);
    }
  }

  std::vector<Prediction> take() { return std::move(predictions_); }

 private:
  void add(Hypothesis hypothesis, std::function<Numbers(std::size_t)> numbers) {
    predictions_.push_back({std::move(hypothesis), std::move(numbers)});
  }

  /// Several may have one id: each is a prediction of its own.
  void addListed() {
    const std::vector<std::string> ids = history_.mistakes();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      add({ids[i], true, {}, static_cast<double>(i)},
          [&history = history_, i](std::size_t call) { return history.listed(i, call); });
    }
  }

  /// Each number of the result changed.
  void addResult(const char* id, double value, const Change& change) {
    add({id, false, {}, value}, [&history = history_, change](std::size_t call) {
      Numbers numbers = history.oracle(call);
      for (double& number : numbers) number = change(number);
      return numbers;
    });
  }

  void addResults(std::size_t size) {
    addResult("wrong_sign", 0, [](double r) { return -r; });
    addResult("doubled", 0, [](double r) { return 2 * r; });
    addResult("halved", 0, [](double r) { return r / 2; });
    addResult("absolute_value", 0, [](double r) { return std::abs(r); });
    addResult("always_negative", 0, [](double r) { return -std::abs(r); });
    addResult("rope", -1, [](double r) { return r < 0 ? 0.0 : r; });
    addResult("rope", +1, [](double r) { return r > 0 ? 0.0 : r; });
    addResult("cut_result", 0, [](double r) { return std::trunc(r); });
    if (size < 2 || size > mostResults) return;
    for (std::size_t i = 0; i < size; ++i) {
      addComponent("missing_component", i, 0.0);
      addComponent("component_sign", i, -1.0);
    }
  }

  void addComponent(const char* id, std::size_t i, double factor) {
    add({id, false, {}, static_cast<double>(i)}, [&history = history_, i, factor](std::size_t call) {
      Numbers numbers = history.oracle(call);
      if (i < numbers.size()) numbers[i] *= factor;
      return numbers;
    });
  }

  void addItem(const ArgumentItem& item) {
    if (item.kind == Kind::Whole) return;
    if (item.kind == Kind::List) return addParts(item.leaf.argument);
    addLeaf(item.leaf);
    if (item.kind == Kind::Field) {
      add({"first_for_all", false, {item.leaf}, 0.0}, [&history = history_, leaf = item.leaf](std::size_t call) {
        return history.oracleWithFirstForAll(call, leaf);
      });
    }
    if (item.kind != Kind::Vector || item.numbers.size() > mostComponents) return;
    for (std::size_t i = 0; i < item.numbers.size(); ++i) {
      addLeaf({item.leaf.argument, item.leaf.field, static_cast<int>(i)});
    }
  }

  /// The oracle asked with another argument.
  void addArgument(const char* id, const Leaf& leaf, double value, const Change& change) {
    add({id, false, {leaf}, value},
        [&history = history_, leaf, change](std::size_t call) { return history.oracleWith(call, leaf, change); });
  }

  void addLeaf(const Leaf& leaf) {
    addArgument("ignored", leaf, 0, [](double) { return 0.0; });
    addArgument("missing_factor", leaf, 1, [](double) { return 1.0; });
    for (const double value : usualConstants) {
      addArgument("constant_argument", leaf, value, [value](double) { return value; });
    }
    addArgument("argument_sign", leaf, 0, [](double p) { return -p; });
    addArgument("argument_size", leaf, 0, [](double p) { return std::abs(p); });
    addArgument("doubled_argument", leaf, 0, [](double p) { return 2 * p; });
    addArgument("halved_argument", leaf, 0, [](double p) { return p / 2; });
    addArgument("squared", leaf, 0, [](double p) { return p * p; });
    addArgument("whole_numbers", leaf, 0, [](double p) { return std::trunc(p); });
    addFactor("factor_too_many", leaf, 1);
    addFactor("factor_too_few", leaf, -1);
    addFactor("multiplied_for_divided", leaf, 2);
    addFactor("divided_for_multiplied", leaf, -2);
  }

  /// The result times a power of an argument that is one number.
  void addFactor(const char* id, const Leaf& leaf, double power) {
    add({id, false, {leaf}, 0.0}, [&history = history_, leaf, power](std::size_t call) {
      Numbers numbers = history.oracle(call);
      for (const ArgumentItem& item : history.items(call)) {
        if (item.leaf != leaf || item.numbers.size() != 1) continue;
        for (double& number : numbers) number *= std::pow(item.numbers.front(), power);
        return numbers;
      }
      return Numbers();
    });
  }

  void addParts(int argument) {
    const auto part = [this, argument](const char* id, Part kept) {
      add({id, false, {{argument, -1, -1}}, 0.0}, [&history = history_, argument, kept](std::size_t call) {
        return history.oracleOfPart(call, argument, kept);
      });
    };
    part("first_skipped", Part::WithoutFirst);
    part("last_skipped", Part::WithoutLast);
    part("first_only", Part::First);
    part("last_only", Part::Last);
  }

  void addPair(int i, int j) {
    const Leaf first{i, -1, -1};
    const Leaf second{j, -1, -1};
    if (!history_.areAlike(i, j)) return;
    add({"swapped_arguments", false, {first, second}, 0.0},
        [&history = history_, i, j](std::size_t call) { return history.oracleSwapped(call, i, j); });
    add({"argument_twice", false, {first, second}, 0.0},
        [&history = history_, i, j](std::size_t call) { return history.oracleWithTwice(call, i, j); });
    add({"argument_twice", false, {second, first}, 0.0},
        [&history = history_, i, j](std::size_t call) { return history.oracleWithTwice(call, j, i); });
  }

  /// One field taken from another argument of the same kind: "lower.L0 where upper.L0 belongs".
  void addSameField(const ArgumentItem& from, const ArgumentItem& to) {
    const bool isOfStructs = from.kind == Kind::Number && to.kind == Kind::Number && from.leaf.field >= 0;
    if (!isOfStructs || from.leaf.field != to.leaf.field || from.leaf == to.leaf) return;
    if (!history_.areAlike(from.leaf.argument, to.leaf.argument)) return;
    add({"argument_twice", false, {from.leaf, to.leaf}, 0.0},
        [&history = history_, from = from.leaf, to = to.leaf](std::size_t call) {
          const double other = numberAt(history.items(call), from);
          return history.oracleWith(call, to, [other](double) { return other; });
        });
  }

  static double numberAt(const std::vector<ArgumentItem>& items, const Leaf& leaf) {
    return std::ranges::find(items, leaf, &ArgumentItem::leaf)->numbers.front();
  }

  const CallHistoryBase& history_;
  std::vector<Prediction> predictions_;
};

}  // namespace

std::vector<Prediction> predictionsOf(const CallHistoryBase& history) { return Builder(history).take(); }

}  // namespace muelle::grader
