#pragma once
#include "engine/model/model_system.h"
#include "harness/trajectory.h"

#include <vector>

namespace muelle::lab {

/// What a motion is measured against: y_i(t) = x_i(t) - x_i(0) - V t and v_i - V, with V the velocity of the centre of
/// mass at the start where nothing ties the scene to a place, else 0. So it is the same at the origin, far away, and
/// flying by.
struct MotionFrame {
  State start;
  std::vector<double> drift;  ///< V of each unknown [m/s]
  int dimension = 3;          ///< unknowns a node
};
MotionFrame frameOf(const engine::ModelSystem& system, const State& start);

/// Whether pins, motions, obstacles, drag or a property of positions tie the system to a place.
bool isTied(const engine::Model& model);

/// A distance between two runs, on the scale of the motion; in SI units where nothing moves.
struct Relative {
  double value = 0.0;
  bool isRelative = true;
};

/// How far a run is from another at the same times: largest distance over times and nodes, over the largest |y| (|v -
/// V|) of the other.
struct Deviation {
  Relative position;      ///< e_x; [m] where no node moves
  Relative velocity;      ///< e_v; [m/s] where no node has a velocity but V
  double roundOff = 0.0;  ///< of positions, on the scale of e_x: what of e_x doubles cannot tell

  /// The larger one of those that are relative, else of both.
  Relative larger() const;
};
/// The trajectories have the same times: throws std::invalid_argument otherwise.
Deviation deviation(const Trajectory& run, const Trajectory& other, const MotionFrame& frame);

/// The same of a number measured along the runs; `rate` is its change per second by the drift alone.
Relative deviation(const Trajectory& run, const Trajectory& other, std::size_t track, double rate);

}  // namespace muelle::lab
