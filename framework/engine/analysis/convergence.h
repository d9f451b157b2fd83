#pragma once
#include <span>

namespace muelle::engine {

/// The order of a method as its errors show it.
struct OrderFit {
  bool found = false;      ///< whether there is a window; the other numbers are 0 when not
  double order = 0.0;      ///< slope of log(error) over log(h), by least squares
  int first = 0;           ///< index of the window's first (largest) step
  int count = 0;           ///< how many steps it has, at least 3
  double deviation = 0.0;  ///< largest |slope between neighbours - order| in the window
};

/// Fits the order over the longest window of at least three successive steps in which the errors follow one power of h:
/// every slope between neighbours within max(0.1, 3 % of the order) of the fitted one. Larger steps, where higher terms
/// of the error still count, bend away and stay out by that; errors up to 100 * roundOff, or not finite, are left out
/// altogether. Of windows of the same length the one with the smaller steps is taken.
///
/// \param hs steps, descending
/// \param errors at the same final time, as long as hs
/// \param roundOff what rounding alone leaves in the errors
/// Throws std::invalid_argument when hs does not descend or the lengths differ.
OrderFit fitOrder(std::span<const double> hs, std::span<const double> errors, double roundOff);

}  // namespace muelle::engine
