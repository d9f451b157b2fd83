#pragma once
#include <array>

/// The method of order five by Dormand and Prince (J. Comput. Appl. Math. 6, 1980): times c and weights a of its
/// stages, the last of which are the step, and off, the weights of the estimated error.
namespace dormand_prince {

inline constexpr std::array<double, 7> c = {0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1};
inline constexpr std::array<std::array<double, 6>, 7> a = {
    {{},
     {1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {44.0 / 45, -56.0 / 15, 32.0 / 9},
     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
inline constexpr std::array<double, 7> off = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                              -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

}  // namespace dormand_prince
