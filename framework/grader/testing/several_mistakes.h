#pragma once
/// \file
/// One mistake with each of some numbers, as a threshold anywhere: of several under one id it is enough that one
/// agrees.
///
///     [[maybe_unused]] static const bool thresholds =
///         registerEach("springForce", "threshold", &oracle::springForce, decades(-1, -99), [](double shortest) {
///           return [shortest](const Vec3& xa, ...) { ... };
///         });

#include "grader/testing/mistakes.h"

#include <cmath>
#include <vector>

namespace muelle::grader {

/// \param mistake gives the function with that mistake, for a number
template <class Signature, class Mistake>
bool registerEach(const char* function, const char* id, Signature* oracle, const std::vector<double>& numbers,
                  const Mistake& mistake) {
  for (const double number : numbers) MistakeRegistration<Signature>(function, id, oracle, mistake(number));
  return true;
}

/// 10^first, ..., 10^last: of two thresholds between the same lengths of a ladder one is as good as the other.
inline std::vector<double> decades(int first, int last) {
  std::vector<double> powers;
  for (int exponent = first; exponent >= last; --exponent) powers.push_back(std::pow(10.0, exponent));
  return powers;
}

}  // namespace muelle::grader
