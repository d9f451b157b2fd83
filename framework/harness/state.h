#pragma once
#include <span>
#include <vector>

namespace muelle {

using In = std::span<const double>;  ///< numbers to read, one per degree of freedom
using Out = std::span<double>;       ///< numbers to write, one per degree of freedom

/// Where a system is: flat arrays with one entry per degree of freedom; node i of a 3D scene has entries 3i, 3i+1,
/// 3i+2.
struct State {
  double t = 0.0;         ///< time [s]
  std::vector<double> x;  ///< positions [m]
  std::vector<double> v;  ///< velocities [m/s], as long as x
  std::vector<double> z;  ///< internal variables (contact modes, friction anchors), frozen within a step; often empty
};

}  // namespace muelle
