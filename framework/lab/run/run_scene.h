#pragma once
#include "engine/scene/scene.h"

#include <memory>
#include <optional>
#include <string>

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
};

/// The scene with the overrides applied, step and tolerance settled for its method:
/// a method without an error estimate takes the step; one with an estimate takes the tolerance, but the step when
/// only that is given for it. Throws std::invalid_argument when a number makes no sense or what the method needs is
/// missing: it says which option gives it.
engine::Scene applied(engine::Scene scene, const RunOverrides& overrides);

/// How a run goes that follows the scene.
engine::RunOptions optionsOf(const engine::Scene& scene);

/// How far the result is off, measured by a second run.
struct ErrorEstimate {
  double difference = 0.0;  ///< relative L2 difference of the final positions of both runs
  double error = 0.0;     ///< of the first run, by Richardson: difference 2^p / (2^p - 1); of an adaptive method as is
  std::string how;        ///< "step halved, order 2"
  double wallTime = 0.0;  ///< of the second run [s]
  std::string failure;    ///< why there is no estimate; empty when there is
};

/// What became of a scene.
struct SceneRun {
  std::unique_ptr<engine::ModelSystem> system;
  engine::MethodInfo method;
  engine::RunOptions options;  ///< without probes: they refer to the system
  engine::RunResult result;
  std::optional<ErrorEstimate> error;

  /// Largest |E(t) - E(0)| over the outputs, relative to max(|E(0)|, largest kinetic energy); 0 when both are.
  double energyDrift() const;
  /// Whether all forces derive from the energy, which should then stay.
  bool isConservative() const;
};

/// Builds and runs a scene as it stands (see applied()). `label` names the progress bar; empty: none.
SceneRun runScene(const engine::Scene& scene, const std::string& label = {});

/// Runs the scene again with half the step (an adaptive method: a tenth of the tolerance) and compares; costs two to
/// three times the run itself. The estimate is only as good as the theory behind it: it assumes that the method shows
/// its order.
ErrorEstimate estimateError(const engine::Scene& scene, const SceneRun& run, const std::string& label = {});

/// The run's trajectory in the scene's numbering of nodes, pinned and moved ones included: D columns a node, D the
/// scene's dimension (node i of a 3D scene has x 3i, 3i+1, 3i+2). Inside, the unknowns are numbered otherwise.
Trajectory trajectoryOf(const SceneRun& run);

/// The summary that `muelle run` prints: method, steps, times, error, energy, work, warnings, events.
std::string summaryOf(const engine::Scene& scene, const SceneRun& run);

}  // namespace muelle::lab
