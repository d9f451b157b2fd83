#pragma once
/// \file
/// MUELLE_FUNCTIONS for demos: submission::f(args) calls what the program has bound to f, by name. So a demo is
/// compiled once, for the student's check and for the grader, which draws it for the submission and for the oracle.

#include "course/testing/demo_binding.h"
#include "course/testing/struct_fields.h"
#include "harness/for_each.h"

#include <functional>
#include <utility>

namespace muelle {

/// A function of the exercise, whosever is bound.
template <class Signature>
class DemoFunction;

template <class Result, class... Args>
class DemoFunction<Result(Args...)> {
 public:
  constexpr explicit DemoFunction(const char* name) : name_(name) {}

  Result operator()(Args... args) const {
    return (*static_cast<const std::function<Result(Args...)>*>(boundToDemo(name_)))(std::forward<Args>(args)...);
  }

 private:
  const char* name_;
};

}  // namespace muelle

#define MUELLE_DEMO_FUNCTION_(function)                                                        \
  namespace submission {                                                                       \
  [[maybe_unused]] constexpr ::muelle::DemoFunction<decltype(::function)> function(#function); \
  }
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_DEMO_FUNCTION_, __VA_ARGS__)
