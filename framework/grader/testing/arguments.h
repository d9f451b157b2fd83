#pragma once
/// \file
/// Registers how arguments of a function look where nothing about them is special: what is built on the function is
/// only judged by the student's own answers when the function is of use there.
///
///     MUELLE_ARGUMENTS(springForceOnA, [](Random& random) {
///       const double xa = random.number(-2, 2), ...;
///       return std::tuple(xa, xb, k, L0);
///     });
///
/// The names in the tuple are those that a student reads. Lists have the same sizes each time, so that one argument may
/// be exchanged for that of another draw; an out-parameter goes in with the same value each time.

#include "course/testing/random.h"
#include "grader/remote/remote_functions.h"
#include "grader/testing/call_history.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace muelle::grader {

/// What the student's function and the oracle's answered to one question.
struct Answers {
  std::vector<double> own, right;
};

/// What a function was asked in general position, and answered.
struct Examination {
  struct Exchanged {
    std::size_t argument;  ///< the place of the one that was taken from another draw
    std::size_t draw;      ///< of the others
    Answers answers;
  };
  std::vector<Answers> draws;
  std::vector<std::vector<double>> again;  ///< the student's answers to the draws, asked once more and backwards
  std::vector<Exchanged> exchanged;
};

/// Why a student's function is of no use to what is built on it.
struct Uselessness {
  std::string complaint;       ///< in the student's words; "" when it is of use
  bool isOneSlipAway = false;  ///< one named mistake that explains all answers makes up for it
};

/// \param arguments their names, for the complaint
Uselessness judgeUse(const Examination& examination, const std::string& function,
                     const std::vector<std::string>& arguments);

/// "xa", "L0" of "[](Random& random) { ... return std::tuple(xa, L0); }"; "" for one that is no plain name.
std::vector<std::string> namesInTuple(const std::string& generator);

/// The registered arguments of one function.
class ArgumentsBase {
 public:
  virtual ~ArgumentsBase() = default;
  /// Asks the student's function. Throws SubmissionFault.
  virtual Uselessness examine(Random random) const = 0;

  /// All of this process, by function.
  static std::map<std::string, std::unique_ptr<ArgumentsBase>>& all();

 protected:
  static constexpr std::size_t drawCount = 6;
};

template <class Signature>
class Arguments;

template <class Result, class... Args>
class Arguments<Result(Args...)> : public ArgumentsBase {
 public:
  using Tuple = std::tuple<std::decay_t<Args>...>;
  using Function = std::function<Result(Args...)>;
  using Generator = std::function<Tuple(Random&)>;

  Arguments(std::string name, RemoteFunction<Result(Args...)> own, Function oracle, Generator generator,
            std::vector<std::string> argumentNames)
      : name_(std::move(name)),
        own_(own),
        oracle_(std::move(oracle)),
        generator_(std::move(generator)),
        argumentNames_(std::move(argumentNames)) {}

  Uselessness examine(Random random) const override {
    std::vector<Tuple> draws;
    for (std::size_t i = 0; i < drawCount; ++i) draws.push_back(generator_(random));
    Examination examination;
    for (const Tuple& draw : draws) examination.draws.push_back(ask(draw));
    exchangeEach(draws, examination, std::index_sequence_for<Args...>());
    examination.again.resize(drawCount);
    for (std::size_t i = drawCount; i-- > 0;) examination.again[i] = ask(draws[i]).own;
    return judgeUse(examination, name_, argumentNames_);
  }

 private:
  using History = CallHistory<Result(Args...)>;

  Answers ask(const Tuple& arguments) const {
    return {History::evaluate(own_, arguments), History::evaluate(oracle_, arguments)};
  }

  template <std::size_t... Is>
  void exchangeEach(const std::vector<Tuple>& draws, Examination& examination, std::index_sequence<Is...>) const {
    (exchange<Is>(draws, examination), ...);
  }

  template <std::size_t I>
  void exchange(const std::vector<Tuple>& draws, Examination& examination) const {
    for (std::size_t i = 0; i < drawCount; ++i) {
      Tuple mixed = draws[i];
      std::get<I>(mixed) = std::get<I>(draws[(i + 1) % drawCount]);
      examination.exchanged.push_back({I, i, ask(mixed)});
    }
  }

  std::string name_;
  Function own_;
  Function oracle_;
  Generator generator_;
  std::vector<std::string> argumentNames_;
};

struct ArgumentsRegistration {
  template <class Signature, class Generator>
  ArgumentsRegistration(const char* name, RemoteFunction<Signature> own, Signature* oracle, Generator generator,
                        const char* source) {
    ArgumentsBase::all()[name] =
        std::make_unique<Arguments<Signature>>(name, own, oracle, generator, namesInTuple(source));
  }
};

}  // namespace muelle::grader

#define MUELLE_ARGUMENTS(function, ...)                                                         \
  [[maybe_unused]] static const ::muelle::grader::ArgumentsRegistration argumentsOf_##function( \
      #function, ::submission::function, &::oracle::function, __VA_ARGS__, #__VA_ARGS__)
