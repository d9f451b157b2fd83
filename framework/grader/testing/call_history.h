#pragma once
#include "course/testing/print_value.h"
#include "grader/remote/numbers.h"
#include "grader/testing/argument_items.h"
#include "grader/wire/signature.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace muelle::grader {

/// The numbers of an argument that the function may have changed.
template <class Parameter, class T>
void appendOutParameter(std::vector<double>& numbers, const T& argument) {
  if constexpr (wire::isOutParameter<Parameter>) appendNumbers(numbers, argument);
}

/// The calls of one function in this process, and what the oracle says to each, and to each with its arguments changed:
/// what the usual mistakes are recognised by. Calls are numbered from 0; all numbers are the result's, then those of
/// the out-parameters.
///
/// Not every change leaves a question of the contract: a spring may be left without one of its nodes. An oracle that
/// throws a std::logic_error there (std::vector::at does) says so; the submission is not asked, and no mistake agrees.
class CallHistoryBase {
 public:
  using Numbers = std::vector<double>;

  virtual ~CallHistoryBase() = default;

  virtual bool hasOracle() const = 0;
  virtual std::size_t calls() const = 0;
  /// What the submission has answered.
  virtual const Numbers& outcome(std::size_t call) const = 0;
  virtual std::vector<ArgumentItem> items(std::size_t call) const = 0;
  /// Where an answer cancels to nothing, the round-off of the arguments is left.
  virtual double roundOff(std::size_t call) const = 0;
  virtual int argumentCount() const = 0;
  virtual bool answersTrueOrFalse() const = 0;
  /// Whether two arguments are of one type.
  virtual bool areAlike(int i, int j) const = 0;

  virtual Numbers oracle(std::size_t call) const = 0;
  virtual Numbers oracleWith(std::size_t call, const Leaf& leaf, const Change& change) const = 0;
  virtual Numbers oracleOfPart(std::size_t call, int argument, Part part) const = 0;
  virtual Numbers oracleWithFirstForAll(std::size_t call, const Leaf& leaf) const = 0;
  virtual Numbers oracleSwapped(std::size_t call, int i, int j) const = 0;
  /// Argument i in place of argument j, too.
  virtual Numbers oracleWithTwice(std::size_t call, int i, int j) const = 0;
  /// What a listed mistake gives.
  virtual Numbers listed(std::size_t mistake, std::size_t call) const = 0;
  /// Asks the submission what it answers to a call with its arguments edited, and takes that as one more call, the
  /// last, also where the tests have made mostCalls; none is added when the answers are too long. Throws
  /// SubmissionFault.
  /// Nothing is asked where the oracle throws.
  virtual void ask(std::size_t call, const Edit& edit) = 0;
  /// Forgets all calls but the first so many.
  virtual void keepOnly(std::size_t calls) = 0;
  /// The arguments of a call, each as source.
  virtual std::vector<std::string> argumentTexts(std::size_t call) const = 0;

  /// Ids of the listed mistakes, in the order of their registration; one may stand several times.
  virtual std::vector<std::string> mistakes() const = 0;

  static constexpr std::size_t mostCalls = 4096;         ///< of the tests
  static constexpr std::size_t mostNumbers = 4'000'000;  ///< in all answers kept; a submission decides their size

  /// All histories of this process, by function.
  static std::map<std::string, std::unique_ptr<CallHistoryBase>>& all();
};

template <class Signature>
class CallHistory;

template <class Result, class... Args>
class CallHistory<Result(Args...)> : public CallHistoryBase {
 public:
  using Tuple = std::tuple<std::decay_t<Args>...>;
  using Given = std::shared_ptr<const Tuple>;
  using Function = std::function<Result(Args...)>;

  static CallHistory& of(const std::string& function) {
    auto& slot = all()[function];
    if (!slot) slot = std::make_unique<CallHistory>();
    return static_cast<CallHistory&>(*slot);
  }

  /// \param outcome the result, if any, then the out-parameters
  void add(const Given& given, Numbers outcome) {
    if (calls_.size() >= room_ || numbers_ + outcome.size() > mostNumbers) return;
    numbers_ += outcome.size();
    calls_.push_back({given, std::move(outcome)});
  }

  /// \param own the submission's function; it adds its calls here
  void setOwn(Function own) {
    if (!own_) own_ = std::move(own);
  }
  void setOracle(Function oracle) { oracle_ = std::move(oracle); }
  void addMistake(std::string id, Function mistake) { mistakes_.emplace_back(std::move(id), std::move(mistake)); }

  bool hasOracle() const override { return static_cast<bool>(oracle_); }
  std::size_t calls() const override { return calls_.size(); }
  const Numbers& outcome(std::size_t call) const override { return calls_[call].outcome; }
  int argumentCount() const override { return static_cast<int>(sizeof...(Args)); }

  std::vector<ArgumentItem> items(std::size_t call) const override {
    std::vector<ArgumentItem> items;
    forEachArgument(*calls_[call].given, [&items](const auto& argument, int index) {
      appendItems(items, argument, {index, -1, -1});
    });
    return items;
  }

  double roundOff(std::size_t call) const override {
    Numbers numbers;
    forEachArgument(*calls_[call].given, [&numbers](const auto& argument, int) { appendNumbers(numbers, argument); });
    return 1e-12 * scaleOf(numbers);
  }

  bool answersTrueOrFalse() const override { return std::is_same_v<Result, bool>; }

  bool areAlike(int i, int j) const override {
    Tuple none{};
    return withBoth(none, i, j, [](auto&, auto&) {});
  }

  Numbers oracle(std::size_t call) const override { return evaluate(oracle_, *calls_[call].given); }
  Numbers listed(std::size_t mistake, std::size_t call) const override {
    return predicted(mistakes_[mistake].second, *calls_[call].given);
  }

  Numbers oracleWith(std::size_t call, const Leaf& leaf, const Change& change) const override {
    return changed(call, [&](auto& argument, int index) {
      if (index == leaf.argument) changeAt(argument, leaf, change);
    });
  }
  Numbers oracleOfPart(std::size_t call, int which, Part part) const override {
    return changed(call, [&](auto& argument, int index) {
      if (index == which) keepPart(argument, part);
    });
  }
  Numbers oracleWithFirstForAll(std::size_t call, const Leaf& leaf) const override {
    return changed(call, [&](auto& argument, int index) {
      if (index == leaf.argument) takeFirstForAll(argument, leaf);
    });
  }
  Numbers oracleSwapped(std::size_t call, int i, int j) const override {
    Tuple arguments = *calls_[call].given;
    withBoth(arguments, i, j, [](auto& first, auto& second) { std::swap(first, second); });
    return predicted(oracle_, std::move(arguments));
  }
  Numbers oracleWithTwice(std::size_t call, int i, int j) const override {
    Tuple arguments = *calls_[call].given;
    withBoth(arguments, i, j, [](auto& first, auto& second) { second = first; });
    return predicted(oracle_, std::move(arguments));
  }

  void ask(std::size_t call, const Edit& edit) override {
    Tuple arguments = *calls_[call].given;
    forEachArgument(arguments, [&edit](auto& argument, int index) {
      if (index != edit.leaf.argument) return;
      if (edit.change) return changeAt(argument, edit.leaf, edit.change);
      keepPart(argument, edit.part);
    });
    if (!own_ || (oracle_ && !answers(oracle_, arguments))) return;
    room_ = std::max(mostCalls, calls_.size() + 1);  // a motion may have taken all
    evaluate(own_, std::move(arguments));
  }
  void keepOnly(std::size_t calls) override {
    for (; calls_.size() > calls; calls_.pop_back()) numbers_ -= calls_.back().outcome.size();
  }

  std::vector<std::string> argumentTexts(std::size_t call) const override {
    std::vector<std::string> texts;
    forEachArgument(*calls_[call].given,
                    [&texts](const auto& argument, int) { texts.push_back(printValue(argument)); });
    return texts;
  }

  std::vector<std::string> mistakes() const override {
    std::vector<std::string> ids;
    for (const auto& [id, mistake] : mistakes_) ids.push_back(id);
    return ids;
  }

  /// The numbers of a call: the result, if any, then the out-parameters.
  static Numbers evaluate(const Function& function, Tuple arguments) {
    Numbers numbers;
    const auto invoke = [&function](auto&... argument) -> Result { return function(static_cast<Args>(argument)...); };
    if constexpr (std::is_void_v<Result>) {
      std::apply(invoke, arguments);
    } else {
      const std::decay_t<Result> result = std::apply(invoke, arguments);
      appendNumbers(numbers, result);
    }
    std::apply([&numbers](const auto&... argument) { (appendOutParameter<Args>(numbers, argument), ...); }, arguments);
    return numbers;
  }

 private:
  struct Call {
    Given given;
    Numbers outcome;
  };

  template <class Visitor>
  Numbers changed(std::size_t call, const Visitor& visit) const {
    Tuple arguments = *calls_[call].given;
    forEachArgument(arguments, visit);
    return predicted(oracle_, std::move(arguments));
  }

  /// What no answer agrees with, where the function throws.
  static Numbers predicted(const Function& function, Tuple arguments) {
    try {
      return evaluate(function, std::move(arguments));
    } catch (const std::logic_error&) {
      return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    }
  }

  static bool answers(const Function& function, const Tuple& arguments) {
    try {
      evaluate(function, arguments);
      return true;
    } catch (const std::logic_error&) {
      return false;
    }
  }

  std::vector<Call> calls_;
  std::size_t numbers_ = 0;
  std::size_t room_ = mostCalls;
  Function own_;
  Function oracle_;
  std::vector<std::pair<std::string, Function>> mistakes_;
};

}  // namespace muelle::grader
