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
#include <functional>
#include <map>
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
class GeneralPosition {
 public:
  using Draw = std::function<UntypedArguments(Random&)>;

  GeneralPosition(const CallHistoryBase& history, std::string function, Draw draw, std::vector<std::string> names)
      : history_(history), function_(std::move(function)), draw_(std::move(draw)), names_(std::move(names)) {}

  /// Asks the student's function. Throws SubmissionFault.
  Uselessness examine(Random random) const;

  /// All of this process, by function.
  static std::map<std::string, GeneralPosition>& all();

 private:
  Answers ask(const UntypedArguments& arguments) const;

  const CallHistoryBase& history_;
  std::string function_;
  Draw draw_;
  std::vector<std::string> names_;  ///< of the arguments
};

/// \param source of the generator
void registerGeneralPosition(const CallHistoryBase& history, const char* function, const GeneralPosition::Draw& draw,
                             const char* source);

struct ArgumentsRegistration {
  template <class Signature, class Generator>
  ArgumentsRegistration(const char* name, RemoteFunction<Signature> own, Signature* oracle, Generator generator,
                        const char* source) {
    auto& history = CallHistory<Signature>::of(name);
    history.setOwn(own);
    history.setOracle(oracle);
    using Tuple = typename CallHistory<Signature>::Tuple;
    registerGeneralPosition(
        history, name, [generator](Random& random) { return withoutTypes(Tuple(generator(random))); }, source);
  }
};

}  // namespace muelle::grader

#define MUELLE_ARGUMENTS(function, ...)                                                         \
  [[maybe_unused]] static const ::muelle::grader::ArgumentsRegistration argumentsOf_##function( \
      #function, ::submission::function, &::oracle::function, __VA_ARGS__, #__VA_ARGS__)
