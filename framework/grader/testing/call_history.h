#pragma once
#include "grader/remote/numbers.h"
#include "grader/testing/untyped_arguments.h"
#include "grader/wire/signature.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
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

  CallHistoryBase(const CallHistoryBase&) = delete;
  CallHistoryBase& operator=(const CallHistoryBase&) = delete;
  virtual ~CallHistoryBase() = default;

  virtual bool hasOracle() const = 0;
  virtual bool answersTrueOrFalse() const = 0;
  /// The same arguments once more.
  virtual UntypedArguments copied(const UntypedArguments& arguments) const = 0;
  /// What is answered to these arguments; they stay as they are. The submission's function adds its call here and may
  /// throw SubmissionFault.
  virtual Numbers askSubmission(const UntypedArguments& arguments) const = 0;
  virtual Numbers askOracle(const UntypedArguments& arguments) const = 0;
  virtual Numbers askListed(std::size_t mistake, const UntypedArguments& arguments) const = 0;

  /// \param outcome the result, if any, then the out-parameters
  void add(UntypedArguments given, Numbers outcome);

  std::size_t calls() const { return calls_.size(); }
  /// What the submission has answered.
  const Numbers& outcome(std::size_t call) const { return calls_[call].outcome; }
  std::vector<ArgumentItem> items(std::size_t call) const;
  /// Where an answer cancels to nothing, the round-off of the arguments is left.
  double roundOff(std::size_t call) const;
  int argumentCount() const { return static_cast<int>(none_.list.size()); }
  /// Whether two arguments are of one type.
  bool areAlike(int i, int j) const;

  Numbers oracle(std::size_t call) const { return askOracle(calls_[call].given); }
  Numbers oracleWith(std::size_t call, const Leaf& leaf, const Change& change) const;
  Numbers oracleOfPart(std::size_t call, int argument, Part part) const;
  Numbers oracleWithFirstForAll(std::size_t call, const Leaf& leaf) const;
  Numbers oracleSwapped(std::size_t call, int i, int j) const;
  /// Argument i in place of argument j, too.
  Numbers oracleWithTwice(std::size_t call, int i, int j) const;
  /// What a listed mistake gives.
  Numbers listed(std::size_t mistake, std::size_t call) const;
  /// Asks the submission what it answers to a call with its arguments edited, and takes that as one more call, the
  /// last, also where the tests have made mostCalls; none is added when the answers are too long. Throws
  /// SubmissionFault.
  /// Nothing is asked where the oracle throws.
  void ask(std::size_t call, const Edit& edit);
  /// Forgets all calls but the first so many.
  void keepOnly(std::size_t calls);
  /// The arguments of a call, each as source.
  std::vector<std::string> argumentTexts(std::size_t call) const { return calls_[call].given.texts(); }

  /// Ids of the listed mistakes, in the order of their registration; one may stand several times.
  const std::vector<std::string>& mistakes() const { return mistakes_; }

  static constexpr std::size_t mostCalls = 4096;         ///< of the tests
  static constexpr std::size_t mostNumbers = 4'000'000;  ///< in all answers kept; a submission decides their size

  /// All histories of this process, by function.
  static std::map<std::string, std::unique_ptr<CallHistoryBase>>& all();

 protected:
  /// \param none arguments of the types that the function takes
  explicit CallHistoryBase(UntypedArguments none) : none_(std::move(none)) {}

  virtual bool canAskSubmission() const = 0;
  void addId(const char* id) { mistakes_.emplace_back(id); }

 private:
  struct Call {
    UntypedArguments given;
    Numbers outcome;
  };

  UntypedArguments copyOf(std::size_t call) const { return copied(calls_[call].given); }
  /// A copy of a call's arguments; the one of that index, if there is one, has been given to `change`.
  UntypedArguments changed(std::size_t call, int index, const std::function<void(const Argument&)>& change) const;
  /// Also where the oracle throws.
  Numbers oracleTo(const UntypedArguments& arguments) const;
  const Argument* at(const UntypedArguments& arguments, int index) const;

  UntypedArguments none_;
  std::vector<Call> calls_;
  std::size_t numbers_ = 0;
  std::size_t room_ = mostCalls;
  std::vector<std::string> mistakes_;
};

template <class Signature>
class CallHistory;

/// What of a history needs the function's types.
template <class Result, class... Args>
class CallHistory<Result(Args...)> : public CallHistoryBase {
 public:
  using Tuple = std::tuple<std::decay_t<Args>...>;
  using Function = std::function<Result(Args...)>;

  CallHistory() : CallHistoryBase(withoutTypes(Tuple{})) {}

  [[gnu::noinline]] static CallHistory& of(const std::string& function) {
    auto& slot = all()[function];
    if (!slot) slot = std::make_unique<CallHistory>();
    return static_cast<CallHistory&>(*slot);
  }

  /// \param own the submission's function; it adds its calls here
  void setOwn(Function own) {
    if (!own_) own_ = std::move(own);
  }
  void setOracle(Function oracle) { oracle_ = std::move(oracle); }
  void addMistake(const char* id, Function mistake) {
    addId(id);
    listed_.push_back(std::move(mistake));
  }

  bool hasOracle() const override { return static_cast<bool>(oracle_); }
  bool answersTrueOrFalse() const override { return std::is_same_v<Result, bool>; }
  UntypedArguments copied(const UntypedArguments& arguments) const override { return withoutTypes(typed(arguments)); }
  Numbers askSubmission(const UntypedArguments& arguments) const override { return evaluate(own_, typed(arguments)); }
  Numbers askOracle(const UntypedArguments& arguments) const override { return evaluate(oracle_, typed(arguments)); }
  Numbers askListed(std::size_t mistake, const UntypedArguments& arguments) const override {
    return evaluate(listed_[mistake], typed(arguments));
  }

 protected:
  bool canAskSubmission() const override { return static_cast<bool>(own_); }

 private:
  static Tuple typed(const UntypedArguments& arguments) { return *static_cast<const Tuple*>(arguments.tuple.get()); }

  /// The numbers of a call: the result, if any, then the out-parameters.
  [[gnu::noinline]] static Numbers evaluate(const Function& function, Tuple arguments) {
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

  Function own_;
  Function oracle_;
  std::vector<Function> listed_;
};

}  // namespace muelle::grader
