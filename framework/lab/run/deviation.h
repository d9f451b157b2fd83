#pragma once
#include "engine/control/motion_frame.h"
#include "engine/control/simulate.h"
#include "engine/scene/scene.h"

#include <vector>

namespace muelle::lab {

/// Sizes of a motion, or of the difference of two: positions and velocities of the nodes, and each output of the scene.
struct Sizes {
  double position = 0.0;        ///< [m], the largest of a node at any output
  double velocity = 0.0;        ///< [m/s], likewise
  std::vector<double> outputs;  ///< in the order of the scene's outputs, paths left out; in their own unit

  /// Takes the larger of each.
  void include(const Sizes& other);
};

/// Which rows of a trajectory two runs are compared at.
std::vector<std::size_t> comparedRows(const Trajectory& trajectory);

/// How far and how fast nodes move in a run, without outputs: |y|, y(t) = x(t) - x(0) - V t, and |v - V| (MotionFrame).
Sizes nodeMotion(const engine::ModelSystem& system, const Trajectory& trajectory);

/// How much moves in a run: y(t) = x(t) - x(0) - V t and v - V (see MotionFrame), and likewise each output.
Sizes motionOf(const engine::Scene& scene, const engine::ModelSystem& system, const Trajectory& trajectory);

/// The largest differences between `rows` of a trajectory and the rows of another, which begins and samples at the same
/// times.
Sizes differenceOf(const engine::Scene& scene, const engine::ModelSystem& system, const Trajectory& a,
                   const std::vector<std::size_t>& rows, const Trajectory& b);

}  // namespace muelle::lab
