#pragma once
/// \file
/// MUELLE_FUNCTIONS for the worker: a table that calls the student's functions with decoded arguments.
/// Included by glue.cpp through the contract; everything here runs beside the student's code and is trusted by nobody.

#include "grader/wire/codec.h"
#include "grader/wire/signature.h"
#include "grader/worker/glue.h"
#include "harness/for_each.h"

#include <tuple>

namespace muelle::grader::worker {

/// Serves calls of one function.
template <class Signature>
struct Serve;

template <class Result, class... Args>
struct Serve<Result(Args...)> {
  template <Result (*Function)(Args...)>
  static void call(wire::Reader& in, wire::Writer& out, HostPort& port) {
    std::tuple<std::decay_t<Args>...> arguments;
    std::apply([&](auto&... argument) { (decodeArgument(in, argument, port), ...); }, arguments);
    in.expectEnd();
    const auto invoke = [](auto&... argument) -> Result { return Function(static_cast<Args>(argument)...); };
    if constexpr (std::is_void_v<Result>) {
      std::apply(invoke, arguments);
    } else {
      const std::decay_t<Result> result = std::apply(invoke, arguments);
      encode(out, result);
    }
    std::apply([&out](auto&... argument) { (encodeOut<Args>(out, argument), ...); }, arguments);
  }

 private:
  template <class T>
  static void decodeArgument(wire::Reader& in, T& argument, HostPort&) {
    using wire::decode;
    decode(in, argument);
  }

  template <class CallbackResult, class... CallbackArgs>
  static void decodeArgument(wire::Reader& in, std::function<CallbackResult(CallbackArgs...)>& argument,
                             HostPort& port) {
    const auto id = in.number<std::uint32_t>();
    argument = [id, &port](CallbackArgs... given) -> CallbackResult {
      using wire::decode;
      using wire::encode;
      wire::Writer request;
      (encode(request, given), ...);
      const std::vector<std::byte> answer = port.callback(id, request.bytes());
      wire::Reader reader(answer);
      std::decay_t<CallbackResult> result;
      decode(reader, result);
      reader.expectEnd();
      return result;
    };
  }

  template <class Parameter, class T>
  static void encodeOut(wire::Writer& out, const T& argument) {
    using wire::encode;
    if constexpr (wire::isOutParameter<Parameter>) encode(out, argument);
  }
};

}  // namespace muelle::grader::worker

#define MUELLE_SERVED_FUNCTION_(function)                                                            \
  ::muelle::grader::worker::ServedFunction{::muelle::grader::wire::functionId(#function), #function, \
                                           &::muelle::grader::worker::Serve<decltype(::function)>::call<&::function>},
#define MUELLE_FUNCTIONS(...)                                                                           \
  namespace muelle::grader::worker {                                                                    \
  constexpr ServedFunction servedFunctions[] = {MUELLE_FOR_EACH(MUELLE_SERVED_FUNCTION_, __VA_ARGS__)}; \
  }
