#pragma once
#include "engine/model/model_system.h"

#include <cstddef>
#include <vector>

namespace muelle::lab {

/// Positions and velocities of all nodes at some times, in the user's numbering and with three components a node, so
/// that runs of differently built models can be compared.
struct PathRows {
  std::vector<double> t;  ///< [s], ascending
  std::vector<std::vector<double>> x, v;

  std::size_t size() const { return t.size(); }
  void add(const engine::ModelSystem& system, const State& state);
  /// Leaves every second row out; the last stays.
  void thin();
};

/// Where a node is [m]; in directions that the model has not, where the scene puts it.
Vec3 placeOf(const engine::ModelSystem& system, const State& state, int node);

/// How far and how fast nodes move, or how far two motions are apart, each at its largest.
struct MotionSize {
  double position = 0.0;  ///< [m]
  double velocity = 0.0;  ///< [m/s]

  /// Takes the larger of each; a number that is none stays.
  void include(const MotionSize& other);
};

/// The largest distance of a node between row i of a motion and row j of another.
MotionSize distanceOf(const PathRows& a, std::size_t i, const PathRows& b, std::size_t j);
/// The same over all times that both have, to rounding.
MotionSize distanceOf(const PathRows& a, const PathRows& b);

/// A distance in parts of a motion: the larger of both parts, which is the error that `muelle run` prints.
double errorIn(const MotionSize& distance, const MotionSize& motion);

}  // namespace muelle::lab
