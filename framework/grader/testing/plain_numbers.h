#pragma once
/// \file
/// Inputs in general position whose numbers a student can type.

#include "harness/types.h"

#include <cmath>

namespace muelle::grader {

/// Of few decimals, as a student may type it: 1.37. \param digits 100 keeps two decimals, 1000 three
inline double tidy(double number, double digits = 100) { return std::round(number * digits) / digits; }

/// The same for each component.
inline Vec3 tidy(const Vec3& vector, double digits = 100) {
  return {tidy(vector[0], digits), tidy(vector[1], digits), tidy(vector[2], digits)};
}

/// One of three rotations about no axis alone, whose entries have few digits. \param number they come in turn
inline Mat3 someTurn(int number) {
  Mat3 aboutX, aboutZ;
  aboutX << 1, 0, 0, 0, 0.6, -0.8, 0, 0.8, 0.6;
  aboutZ << 0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1;
  switch (number % 3) {
    case 0:
      return aboutX * aboutZ;
    case 1:
      return aboutZ * aboutX;
    default:
      return aboutX.transpose() * aboutZ * aboutX;
  }
}

}  // namespace muelle::grader
