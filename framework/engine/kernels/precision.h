#pragma once

namespace muelle::engine::kernels {

/// In what the force of a spring is computed. Positions, velocities and accelerations are doubles in both.
enum class Precision {
  Double,
  /// Differences of positions in double or of 32-bit integers (FixedPoint), the rest in floats: forces are off by some
  /// 1e-7 of the largest at a node. In 2D and 3D; where a size leaves the range of floats, in double.
  Single,
};

}  // namespace muelle::engine::kernels
