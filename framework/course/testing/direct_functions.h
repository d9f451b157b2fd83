#pragma once
/// \file
/// MUELLE_FUNCTIONS for the public tests: submission::f(args) calls the student's f in this process and remembers the
/// call, so that a failure can print it as a line to paste and a crash can name it. The demo of the program calls it,
/// too.

#include "course/testing/brief_exception.h"
#include "course/testing/call_record.h"
#include "course/testing/demo_binding.h"
#include "course/testing/never_written.h"
#include "course/testing/struct_fields.h"
#include "course/testing/test_function.h"
#include "harness/for_each.h"

#include <exception>
#include <type_traits>
#include <utility>

namespace muelle {

/// A function of the exercise, called in this process.
template <class Signature>
class DirectFunction;

template <class Result, class... Args>
class DirectFunction<Result(Args...)> {
 public:
  constexpr DirectFunction(const char* name, Result (*function)(Args...)) : name_(name), function_(function) {}

  Result operator()(Args... args) const {
    const CallRecord record(name_, args...);
    try {
      return call(std::forward<Args>(args)...);
    } catch (const BadQuestion& question) {
      CallRecord::badQuestion() = question.what();
      throw;
    } catch (const std::exception& error) {
      rethrowBriefly(error);
    }
  }

 private:
  Result call(Args... args) const {
    // What comes in with such bits may go out with them.
    const bool mayJudge = CallRecord::printsArguments() && !(holdsFill(args) || ...);
    if constexpr (std::is_void_v<Result>) {
      function_(std::forward<Args>(args)...);
      if (mayJudge && (isFilledOutput<Args>(args) || ...)) note();
    } else {
      Result result = function_(std::forward<Args>(args)...);
      if (mayJudge && (holdsFill(result) || (isFilledOutput<Args>(args) || ...))) note();
      return result;
    }
  }
  /// An argument that the function writes to holds what nobody has written.
  template <class Arg>
  static bool isFilledOutput(const std::remove_reference_t<Arg>& arg) {
    constexpr bool isOutput = std::is_lvalue_reference_v<Arg> && !std::is_const_v<std::remove_reference_t<Arg>>;
    if constexpr (isOutput) return holdsFill(arg);
    return false;
  }
  void note() const {
    if (CallRecord::neverWritten().empty()) CallRecord::neverWritten() = name_;
  }

  const char* name_;
  Result (*function_)(Args...);
};

}  // namespace muelle

#define MUELLE_DIRECT_FUNCTION_(function)                                                                     \
  namespace submission {                                                                                      \
  [[maybe_unused]] constexpr ::muelle::DirectFunction<decltype(::function)> function(#function, &::function); \
  [[maybe_unused]] static const ::muelle::DemoBinding<decltype(::function)> muelleDemoOf_##function(          \
      ::muelle::DemoOf::Submission, #function, function);                                                     \
  }
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_DIRECT_FUNCTION_, __VA_ARGS__)
