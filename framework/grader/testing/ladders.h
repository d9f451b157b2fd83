#pragma once
/// \file
/// What every exercise is asked, stated once: lengths down to the shortest, stiffnesses from the softest to the
/// hardest, lists from none to many. Contracts name the ends (MUELLE_RANGE); the values between are in general
/// position, so that no power, no half and no double of one is another.

#include <array>
#include <cmath>
#include <vector>

namespace muelle::grader {

/// Stiffnesses [N/m]: both ends, and some between.
inline constexpr std::array stiffnessLadder = {1e-3, 0.037, 7.3, 310.0, 2.9e5, 1e9};

/// Numbers of springs.
inline constexpr std::array countLadder = {0, 1, 2, 3, 9, 40};

/// Lengths [m], each about a tenth of the one before, from 0.3 down to `shortest`, which is the last. Beside the
/// origin, where a position can be as small.
inline std::vector<double> lengthLadder(double shortest) {
  std::vector<double> lengths;
  for (double length = 0.3; length > shortest; length *= length > 1e-24 ? 0.097 : 1.3e-8) lengths.push_back(length);
  lengths.push_back(shortest);
  return lengths;
}

/// Lengths [m] that a position of 1 m + length holds exactly: 2^-k, down to the last bit of 1 (k = 52).
inline std::vector<double> exactLengthLadder() {
  std::vector<double> lengths;
  for (const int k : {2, 5, 9, 14, 20, 26, 32, 38, 44, 49, 52}) lengths.push_back(std::ldexp(1.0, -k));
  return lengths;
}

}  // namespace muelle::grader
