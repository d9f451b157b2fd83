#pragma once
#include <functional>

namespace muelle::engine {

/// Smallest z in (0, most] at which `holds` fails, to a relative 1e-7: a scan in steps of 2 % from 0.05, then
/// bisection. Infinite when it never does. When it fails at 0.05 already: 0, or with `searchBelow` the bisection goes
/// on down to 1e-9. Bubbles of failure narrower than the steps are not seen.
double firstFailure(const std::function<bool(double z)>& holds, double most, bool searchBelow = false,
                    double ratio = 1.02);

}  // namespace muelle::engine
