#pragma once
#include "grader/remote/numbers.h"
#include "grader/wire/signature.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace muelle::grader {

/// The numbers of an argument that the function may have changed.
template <class Parameter, class T>
void appendOutParameter(std::vector<double>& numbers, const T& argument) {
  if constexpr (wire::isOutParameter<Parameter>) appendNumbers(numbers, argument);
}

/// The calls of one function in this process, and the usual mistakes that its answers are held against.
class CallHistoryBase {
 public:
  virtual ~CallHistoryBase() = default;

  /// The mistake that explains every answer, or "".
  ///
  /// A hypothesis explains the submission when it gives the submission's numbers on all calls, right and wrong ones,
  /// and at least `fewestWrong` of them are wrong. Two hypotheses that explain everything and differ from each other
  /// nowhere are one mistake under two names: the first registered is taken.
  virtual std::string diagnosis() const = 0;

  /// Ids of the mistakes that it knows.
  virtual std::vector<std::string> mistakes() const = 0;

  static constexpr int fewestWrong = 3;
  static constexpr std::size_t mostCalls = 4096;
  static constexpr std::size_t mostNumbers = 4'000'000;  ///< in all answers kept; a submission decides their size

  /// All histories of this process, by function.
  static std::map<std::string, std::unique_ptr<CallHistoryBase>>& all();
};

template <class Signature>
class CallHistory;

template <class Result, class... Args>
class CallHistory<Result(Args...)> : public CallHistoryBase {
 public:
  using Given = std::shared_ptr<const std::tuple<std::decay_t<Args>...>>;
  using Hypothesis = std::function<Result(Args...)>;

  static CallHistory& of(const std::string& function) {
    auto& slot = all()[function];
    if (!slot) slot = std::make_unique<CallHistory>();
    return static_cast<CallHistory&>(*slot);
  }

  /// \param outcome the result, if any, then the out-parameters
  void add(const Given& given, std::vector<double> outcome) {
    numbers_ += outcome.size();
    if (calls_.size() >= mostCalls || numbers_ > mostNumbers) return;
    calls_.push_back({given, std::move(outcome)});
  }

  void setOracle(Hypothesis oracle) { oracle_ = std::move(oracle); }
  void addMistake(std::string id, Hypothesis mistake) { mistakes_.emplace_back(std::move(id), std::move(mistake)); }

  std::vector<std::string> mistakes() const override {
    std::vector<std::string> ids;
    for (const auto& [id, mistake] : mistakes_) ids.push_back(id);
    return ids;
  }

  std::string diagnosis() const override {
    if (!oracle_ || calls_.empty()) return "";
    for (const auto& [id, mistake] : mistakes_) {
      if (explains(mistake)) return id;
    }
    return "";
  }

 private:
  struct Call {
    Given given;
    std::vector<double> outcome;
  };

  bool explains(const Hypothesis& mistake) const {
    int wrong = 0;
    for (const Call& call : calls_) {
      const std::vector<double> expected = evaluate(oracle_, *call.given);
      const std::vector<double> predicted = evaluate(mistake, *call.given);
      const double floor = roundOffOf(*call.given);
      if (!agree(call.outcome, predicted, floor)) return false;
      if (!agree(call.outcome, expected, floor)) ++wrong;
    }
    return wrong >= fewestWrong;
  }

 public:
  /// The numbers of a call: the result, if any, then the out-parameters.
  static std::vector<double> evaluate(const Hypothesis& function, std::tuple<std::decay_t<Args>...> arguments) {
    std::vector<double> numbers;
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
  /// Where a result cancels to nothing, the round-off of the arguments is left.
  static double roundOffOf(const std::tuple<std::decay_t<Args>...>& arguments) {
    std::vector<double> numbers;
    std::apply([&numbers](const auto&... argument) { (appendNumbers(numbers, argument), ...); }, arguments);
    return 1e-12 * scaleOf(numbers);
  }

  std::vector<Call> calls_;
  std::size_t numbers_ = 0;
  Hypothesis oracle_;
  std::vector<std::pair<std::string, Hypothesis>> mistakes_;
};

}  // namespace muelle::grader
