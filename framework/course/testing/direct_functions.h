#pragma once
/// \file
/// MUELLE_FUNCTIONS for the public tests and demos: submission::f(args) calls the student's f in this process and
/// remembers the call, so that a failure can print it as a line to paste and a crash can name it.

#include "course/testing/call_record.h"
#include "course/testing/struct_fields.h"
#include "harness/for_each.h"

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
    return function_(std::forward<Args>(args)...);
  }

 private:
  const char* name_;
  Result (*function_)(Args...);
};

}  // namespace muelle

#define MUELLE_DIRECT_FUNCTION_(function)                                                                     \
  namespace submission {                                                                                      \
  [[maybe_unused]] constexpr ::muelle::DirectFunction<decltype(::function)> function(#function, &::function); \
  }
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_DIRECT_FUNCTION_, __VA_ARGS__)
