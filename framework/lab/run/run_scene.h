#pragma once
#include "engine/scene/scene.h"
#include "lab/run/energy_balance.h"
#include "lab/run/foresight.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace muelle::lab {

/// What the command line says otherwise than the scene.
struct RunOverrides {
  std::string method;  ///< id of the catalogue ("velocity-verlet" is understood, too); empty: the scene's
  std::optional<double> step;
  std::optional<double> tolerance;
  std::optional<double> duration;
  std::optional<double> outputInterval;
  std::optional<bool> events;  ///< whether steps end at contacts and jumps
  bool compensated = false;
  std::vector<std::string> without;  ///< names of parts of the model that are left out: see engine::withoutParts()
};

/// The scene with the overrides applied, step and tolerance settled for its method:
/// a method without an error estimate takes the step; one with an estimate takes the tolerance, but the step when
/// only that is given for it. Throws std::invalid_argument when a number makes no sense or what the method needs is
/// missing: it says which option gives it.
engine::Scene applied(engine::Scene scene, const RunOverrides& overrides);

/// How a run goes that follows the scene.
engine::RunOptions optionsOf(const engine::Scene& scene);

/// An error in parts of what moves; in metres and m/s where nothing does.
struct PartError {
  double value = 0.0;
  bool absolute = false;  ///< nothing moves: in the unit of the thing itself
};

/// How far the result is off, measured by runs with other steps (see estimateError()): the largest difference of a node
/// at any output, in parts of the largest y(t) = x(t) - x(0) - V t; likewise of v - V, and each output (see
/// engine::MotionFrame). So it is the same wherever the origin lies and however fast all of it flies by.
struct ErrorEstimate {
  double position = 0.0;
  double velocity = 0.0;
  std::vector<PartError> outputs;  ///< in the order of the scene's outputs, paths left out
  bool absolute = false;           ///< nothing moves: [m] and [m/s]
  bool atRounding = false;         ///< as good as the rounding of positions lets one tell
  std::string how;                 ///< "step halved, order 2 seen"
  double wallTime = 0.0;           ///< of the other runs [s]
  std::string failure;             ///< why there is no estimate; empty when there is

  /// *The* error: the larger of the two.
  double error() const { return std::max(position, velocity); }
};

/// What became of a scene.
struct SceneRun {
  std::unique_ptr<engine::ModelSystem> system;
  engine::MethodInfo method;
  engine::RunOptions options;  ///< without probes: they refer to the system
  engine::RunResult result;
  EnergyBalance energy;
  std::optional<ErrorEstimate> error;
};

/// Builds and runs a scene as it stands (see applied()). `label` names the progress bar; empty: none. Throws
/// std::invalid_argument, before anything is built, when it needs more memory than is `available` [byte].
SceneRun runScene(const engine::Scene& scene, const std::string& label = {}, double available = availableMemory());

/// The run's trajectory in the scene's numbering of nodes, pinned and moved ones included: D columns a node, D the
/// scene's dimension (node i of a 3D scene has x 3i, 3i+1, 3i+2). Inside, the unknowns are numbered otherwise.
Trajectory trajectoryOf(const SceneRun& run);
/// The letters of those columns: "x", the two of a plane's axes, or "xyz".
std::string axesOf(const engine::Model& model);

/// The summary that `muelle run` prints: method, steps, times, error, energy, work, warnings, events.
std::string summaryOf(const engine::Scene& scene, const SceneRun& run);
/// A line for each part of the model, as the summary's lines: its elements, and how often one was evaluated in the run.
std::string workOfParts(const SceneRun& run);

}  // namespace muelle::lab
