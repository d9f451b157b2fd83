#pragma once
/// \file
/// MUELLE_FUNCTIONS for the hidden tests: submission::f(args) is a call to the sandboxed worker, oracle::f is declared
/// with the contract's signature, and every call is kept for the diagnosis of misconceptions. given::f is what a
/// function that is built on f may be held against: oracle::f, or the student's f in a run that asks whether the one is
/// right given the other.

#include "course/testing/demo_binding.h"
#include "grader/remote/fault.h"
#include "grader/remote/own_lower.h"
#include "grader/remote/session.h"
#include "grader/testing/call_history.h"
#include "grader/wire/codec.h"
#include "grader/wire/signature.h"
#include "harness/for_each.h"

#include <tuple>
#include <utility>
#include <vector>

namespace muelle::grader {

/// A call with everything but its arguments' bytes.
Request requestFor(const char* function, const UntypedArguments& given);

/// Adds a call and its answer to the history, and says it when memory was returned to which nothing was written.
void keepCall(CallHistoryBase& history, const char* function, const UntypedArguments& given,
              std::vector<double> outcome);

/// A function of the contract, evaluated in another process.
template <class Signature>
class RemoteFunction;

template <class Result, class... Args>
class RemoteFunction<Result(Args...)> {
 public:
  constexpr explicit RemoteFunction(const char* name) : name_(name) {}

  /// Throws SubmissionFault when the student's code does not return a value of the right shape.
  Result operator()(Args... args) const;

 private:
  using History = CallHistory<Result(Args...)>;

  /// Keeps the call for the diagnosis: result, then out-parameters.
  void remember(const UntypedArguments& given, std::vector<double> outcome, const std::decay_t<Args>&... args) const {
    (appendOutParameter<Args>(outcome, args), ...);
    History& history = History::of(name_);
    history.setOwn(*this);
    keepCall(history, name_, given, std::move(outcome));
  }

  template <class T>
  static void encodeArgument(wire::Writer& writer, Request&, const T& argument) {
    using wire::encode;
    encode(writer, argument);
  }

  template <class CallbackResult, class... CallbackArgs>
  static void encodeArgument(wire::Writer& writer, Request& request,
                             const std::function<CallbackResult(CallbackArgs...)>& function) {
    writer.number(static_cast<std::uint32_t>(request.callbacks.size()));
    request.callbacks.push_back([function](std::span<const std::byte> bytes) {
      using wire::decode;
      using wire::encode;
      wire::Reader reader(bytes);
      std::tuple<std::decay_t<CallbackArgs>...> arguments;
      std::apply([&reader](auto&... argument) { (decode(reader, argument), ...); }, arguments);
      reader.expectEnd();
      wire::Writer answer;
      encode(answer, static_cast<const std::decay_t<CallbackResult>&>(std::apply(function, arguments)));
      return std::move(answer.bytes());
    });
  }

  template <class Parameter, class T>
  static void decodeOut(wire::Reader& reader, T& argument) {
    using wire::decode;
    if constexpr (wire::isOutParameter<Parameter>) decode(reader, argument);
  }

  const char* name_;
};

template <class Result, class... Args>
Result RemoteFunction<Result(Args...)>::operator()(Args... args) const {
  // Copied before the call: an out-parameter changes, a description outlives the caller's objects.
  const UntypedArguments given = withoutTypes(std::tuple<std::decay_t<Args>...>(args...));
  Request request = requestFor(name_, given);
  wire::Writer writer;
  (encodeArgument(writer, request, args), ...);
  request.arguments = std::move(writer.bytes());

  Session& session = Session::current();
  const std::vector<std::byte> reply = session.call(request);
  try {
    wire::Reader reader(reply);
    if constexpr (std::is_void_v<Result>) {
      (decodeOut<Args>(reader, args), ...);
      reader.expectEnd();
      remember(given, {}, args...);
    } else {
      using wire::decode;
      std::decay_t<Result> result;
      decode(reader, result);
      (decodeOut<Args>(reader, args), ...);
      reader.expectEnd();
      std::vector<double> outcome;
      appendNumbers(outcome, result);
      remember(given, std::move(outcome), args...);
      return result;
    }
  } catch (const wire::WireError& error) {
    session.fail(SubmissionFault(std::string(name_) + " returned something else than its type: " + error.what()));
  }
}

/// The oracle's function, or the student's where the process was told so (own_lower.h).
template <class Signature>
class GivenFunction;

template <class Result, class... Args>
class GivenFunction<Result(Args...)> {
 public:
  constexpr GivenFunction(const char* name, Result (*oracle)(Args...)) : name_(name), own_(name), oracle_(oracle) {}

  Result operator()(Args... args) const {
    if (isOwnLower(name_)) return own_(std::forward<Args>(args)...);
    return oracle_(std::forward<Args>(args)...);
  }

 private:
  const char* name_;
  RemoteFunction<Result(Args...)> own_;
  Result (*oracle_)(Args...);
};

}  // namespace muelle::grader

// The calls of an exercise are compiled in one source of its hidden tests, by the first of these defines, and the
// others link to it, by the second. With neither a source compiles what it calls.
#if defined(MUELLE_REMOTE_CALLS_HERE)
#define MUELLE_REMOTE_CALL_(function)                                      \
  namespace submission {                                                   \
  [[gnu::used]] static constexpr auto muelleCallOf_##function =            \
      &::muelle::grader::RemoteFunction<decltype(::function)>::operator(); \
  }
#elif defined(MUELLE_REMOTE_CALLS_ELSEWHERE)
#define MUELLE_REMOTE_CALL_(function) extern template class ::muelle::grader::RemoteFunction<decltype(::function)>;
#else
#define MUELLE_REMOTE_CALL_(function)
#endif
#define MUELLE_REMOTE_FUNCTION_(function)                                                                          \
  MUELLE_REMOTE_CALL_(function)                                                                                    \
  namespace oracle {                                                                                               \
  decltype(::function) function;                                                                                   \
  }                                                                                                                \
  namespace submission {                                                                                           \
  [[maybe_unused]] constexpr ::muelle::grader::RemoteFunction<decltype(::function)> function(#function);           \
  }                                                                                                                \
  namespace given {                                                                                                \
  inline constexpr ::muelle::grader::GivenFunction<decltype(::function)> function(#function, &::oracle::function); \
  }
// The demo of the program is drawn for the submission and for the oracle.
#if defined(MUELLE_REMOTE_CALLS_HERE)
#define MUELLE_BOUND_FUNCTION_(function)                                                                          \
  MUELLE_REMOTE_FUNCTION_(function)                                                                               \
  namespace submission {                                                                                          \
  static const ::muelle::DemoBinding<decltype(::function)> muelleDemoOf_##function(::muelle::DemoOf::Submission,  \
                                                                                   #function, function);          \
  static const ::muelle::DemoBinding<decltype(::function)> muelleReferenceOf_##function(::muelle::DemoOf::Oracle, \
                                                                                        #function,                \
                                                                                        &::oracle::function);     \
  }
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_BOUND_FUNCTION_, __VA_ARGS__)
#else
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_REMOTE_FUNCTION_, __VA_ARGS__)
#endif
