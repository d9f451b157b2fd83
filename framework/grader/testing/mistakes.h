#pragma once
/// \file
/// Registers the usual mistakes of an exercise: what a function would return if its author had made that mistake.
///
///     MUELLE_MISTAKE(springForce, wrong_sign, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
///       return Vec3(-oracle::springForce(xa, xb, k, L0));
///     });
///
/// The id stands in exercise.toml with what is said to the student.
///
/// A mistake that every exercise may have (common_mistake.h: the wrong sign, half, twice) needs no function, and
/// `check` names it too:
///
///     MUELLE_COMMON_MISTAKE(springForce, wrong_sign);

#include "course/testing/common_mistake.h"
#include "grader/testing/call_history.h"

#include <functional>
#include <utility>

namespace muelle::grader {

template <class Signature>
struct MistakeRegistration {
  /// Not inlined: an exercise has tens of these, and all run in one function, before main.
  [[gnu::noinline]] MistakeRegistration(const char* function, const char* id, Signature* oracle,
                                        std::function<Signature> hypothesis) {
    auto& history = CallHistory<Signature>::of(function);
    history.setOracle(oracle);
    history.addMistake(id, std::move(hypothesis));
  }
};

/// What the oracle returns, times the factor of a common mistake. Throws std::bad_optional_access for an id that is
/// none.
template <class Result, class... Args>
auto commonMistake(Result (*oracle)(Args...), const char* id) {
  return [oracle, factor = commonFactor(id).value()](Args... args) { return Result(factor * oracle(args...)); };
}

}  // namespace muelle::grader

#define MUELLE_MISTAKE(function, id, ...)                                                                              \
  [[maybe_unused]] static const ::muelle::grader::MistakeRegistration<decltype(::function)> mistake_##function##_##id( \
      #function, #id, &::oracle::function, __VA_ARGS__)

#define MUELLE_COMMON_MISTAKE(function, id) \
  MUELLE_MISTAKE(function, id, ::muelle::grader::commonMistake(&::oracle::function, #id))
