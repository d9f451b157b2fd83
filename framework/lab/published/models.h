#pragma once
/// \file
/// Small models in a row, and what is asked of them. A 1D model's displacements are counted from where its springs are
/// at rest.

#include "engine/model/model_system.h"

#include <memory>
#include <numbers>
#include <vector>

namespace muelle::published {

using engine::Model;

constexpr double pi = std::numbers::pi;

/// A spring of a row between nodes a and b, -1 the wall on the left, -2 that on the right.
struct RowSpring {
  int a, b;
  double k;
  double c = 0.0;  ///< its damping
};

/// Masses in a row (1D), springs at rest, walls as pinned nodes behind the masses: so far apart that none passes
/// another, for a spring of 1D pushes the other way beyond its anchor.
Model row(const std::vector<double>& masses, const std::vector<RowSpring>& springs);

/// Displacement and velocity of a node in the state of a model.
struct Motion1D {
  double x = 0.0;
  double v = 0.0;
};

/// A node of a 1D model at a time: its displacement from where it starts, with steps of `h` (Dormand-Prince 8, whose
/// error at a hundredth of the shortest period is far below any printed digit).
Motion1D motionAt(const Model& model, int node, double t, double h);

/// The same at 0, dt, 2 dt ... up to `duration`.
std::vector<Motion1D> motionOf(const Model& model, int node, double duration, double dt, double h);

/// The frequencies of free vibration about the model's start, ascending [Hz].
std::vector<double> frequenciesOf(const Model& model);

}  // namespace muelle::published
