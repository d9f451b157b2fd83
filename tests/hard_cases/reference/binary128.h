#pragma once
/// \file
/// Numbers of 113 bits for references: GCC's __float128 with libquadmath. Tests only.

#include <quadmath.h>
#include <string>
#include <vector>

namespace muelle::hard_cases {

__extension__ typedef __float128 Quad;
using QuadVector = std::vector<Quad>;

/// A decimal number, exactly rounded: quad("9.81").
inline Quad quad(const char* decimal) { return strtoflt128(decimal, nullptr); }

/// 25 significant digits.
inline std::string text(Quad value) {
  char buffer[64];
  quadmath_snprintf(buffer, sizeof buffer, "%.24Qe", value);
  return buffer;
}

}  // namespace muelle::hard_cases
