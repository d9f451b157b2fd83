#pragma once
#include "engine/analysis/numerical_damping.h"
#include "engine/control/simulate.h"
#include "engine/model/model_system.h"

#include <optional>
#include <string>

namespace muelle::lab {

/// What a scene may do with its energy.
enum class EnergyFate {
  Kept,        ///< all forces derive from the energy
  KeptOrLost,  ///< besides there is damping, drag or friction
  Open,        ///< something drives it: a force of time, a motion, an obstacle that moves
};
EnergyFate energyFate(const engine::ModelSystem& system);

/// The scale of a scene's energies [J]: the kinetic energy of v - V at the start (V as in MotionFrame), the elastic
/// energy at the start, and what the forces at the start could do along the scene's extent, sum_i |F_i| extent. Unlike
/// the energy itself it depends neither on where heights are measured from nor on how fast all flies by. The extent
/// counts the way to the obstacles; a lone node with no obstacle, or in touch with one, has none: then it is `way` [m],
/// how far a run goes.
double energyScale(const engine::ModelSystem& system, double way = 0.0);

/// A run's energy, relative to its start.
struct EnergyBalance {
  EnergyFate fate = EnergyFate::Open;
  double scale = 0.0;    ///< see energyScale() [J]
  double start = 0.0;    ///< [J]
  double end = 0.0;      ///< less the start [J]
  double highest = 0.0;  ///< over the outputs, or see `interpolated`, less the start [J]
  double lowest = 0.0;   ///< likewise [J]
  /// What the outputs show in place of `highest`, where they lie between steps and no step ends so high: a state
  /// between two steps is interpolated, and of a stiff spring a small error of place is much energy [J].
  std::optional<double> interpolated = {};
  /// The gain that the method's own, modified energy allows at this step [J]; looked for only when there is a gain of
  /// more than 5 % of the scale.
  double allowed = 0.0;
  /// What the stability function takes; only of an implicit method that loses by a fixed step, in a scene that nothing
  /// drives, and that has lost some.
  std::optional<engine::StabilityFunctionLoss> linearLoss = {};
  /// Whether it rises by more than 5 % of the scale and than the method's modified energy allows, in a scene that can
  /// only keep or lose it: then the run is none of this scene.
  bool fails() const;
};
/// One sentence for a balance that fails: by how much, and what to do.
std::string energyFailure(const EnergyBalance& balance);
/// "the loss of 0.31 J is 2.9 % of the scene's 10.8 J; ...": where linearLoss is known; else empty.
std::string energyLoss(const EnergyBalance& balance);
/// \param method  id of the run's
/// Throws std::out_of_range when the run has not measured its energy.
EnergyBalance energyBalance(const engine::ModelSystem& system, const std::string& method,
                            const engine::RunOptions& options, const engine::RunResult& result);

/// Beyond this share of an energy that should be kept a run's loss says that it is of another motion.
inline constexpr double mostLoss = 0.1;
/// The part of the energy scale that `finest` has lost for good, over its last third, where all of it should be kept; 0
/// elsewhere.
/// \param balance  of a run of the same scene
double lostEnergy(const EnergyBalance& balance, const engine::RunResult& finest);

}  // namespace muelle::lab
