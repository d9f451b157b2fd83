#pragma once
/// \file
/// A function of a made-up exercise, force(x, k, L0) = -k (x - L0), and what a submission answers in its place.

#include "grader/testing/call_history.h"

#include <cmath>

namespace muelle::grader {

inline constexpr const char* springContract = R"(
/// Force [N] of a spring of length x, with force() in words.
double force(double x, double k, double L0);
double acceleration(double x, double k, double L0, const std::vector<double>& m);
MUELLE_RANGE(k, 1e-3, 1e9)
MUELLE_RANGE(L0, 0, 10)
MUELLE_FUNCTIONS(force, acceleration)
)";

inline double rightForce(double x, double k, double L0) { return -k * (x - L0); }

using ForceHistory = CallHistory<double(double, double, double)>;
using ForceFunction = ForceHistory::Function;

/// Asks `own` for `count` springs in general position, stretched and compressed, and adds the calls.
inline void ask(ForceHistory& history, const ForceFunction& own, int count = 12, double shortest = 0.2) {
  history.setOracle(rightForce);
  for (int i = 0; i < count; ++i) {
    const double x = shortest + 0.37 * i, k = 11.3 + 7.1 * (i * i % 7), L0 = 1.13 + 0.21 * (i % 5);
    history.add(withoutTypes(std::tuple<double, double, double>(x, k, L0)), {own(x, k, L0)});
  }
  history.setOwn([&history, own](double x, double k, double L0) {
    const double answer = own(x, k, L0);
    history.add(withoutTypes(std::tuple<double, double, double>(x, k, L0)), {answer});
    return answer;
  });
}

}  // namespace muelle::grader
