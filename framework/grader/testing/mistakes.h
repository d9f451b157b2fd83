#pragma once
/// \file
/// Registers the usual mistakes of an exercise: what a function would return if its author had made that mistake.
///
///     MUELLE_MISTAKE(springForce, wrong_sign, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
///       return Vec3(-oracle::springForce(xa, xb, k, L0));
///     });
///
/// The id stands in exercise.toml with what is said to the student.

#include "grader/testing/call_history.h"

namespace muelle::grader {

template <class Signature>
struct MistakeRegistration {
  template <class Hypothesis>
  MistakeRegistration(const char* function, const char* id, Signature* oracle, Hypothesis hypothesis) {
    auto& history = CallHistory<Signature>::of(function);
    history.setOracle(oracle);
    history.addMistake(id, hypothesis);
  }
};

}  // namespace muelle::grader

#define MUELLE_MISTAKE(function, id, ...)                                                                              \
  [[maybe_unused]] static const ::muelle::grader::MistakeRegistration<decltype(::function)> mistake_##function##_##id( \
      #function, #id, &::oracle::function, __VA_ARGS__)
