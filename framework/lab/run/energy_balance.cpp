#include "lab/run/energy_balance.h"

#include "engine/control/motion_frame.h"
#include "engine/integrators/catalogue.h"
#include "lab/run/deviation.h"
#include "lab/run/energy_climb.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double mostGain = 0.05;  // of the energy scale
/// Energies are sums of terms that cancel: below this part of the terms a change is rounding.
constexpr double rounding = 1e-11;

/// The signed distance [m] of a point from an obstacle's surface as it stands at the start.
double distanceTo(const Obstacle& obstacle, const Vec3& x) {
  const Vec3 r = x - obstacle.centre;
  switch (obstacle.kind) {
    case Obstacle::Kind::Plane:
      return obstacle.normal.normalized().dot(r);
    case Obstacle::Kind::Sphere:
      return r.norm() - obstacle.radius;
    case Obstacle::Kind::Box:
      return (r.cwiseAbs() - obstacle.halfSize).cwiseMax(0.0).norm();
  }
  return 0.0;
}

/// The longest way to an obstacle, each measured from the node that is nearest to it.
double wayToObstacles(const Model& model) {
  double longest = 0.0;
  for (const Obstacle& obstacle : model.obstacles) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const ModelNode& node : model.nodes) nearest = std::min(nearest, std::abs(distanceTo(obstacle, node.x)));
    longest = std::max(longest, nearest);
  }
  return longest;
}

double kineticEnergyOf(const ModelSystem& system, State state, const std::vector<double>& drift) {
  for (int i = 0; i < system.size(); ++i) {
    state.v[laneOf(system, i)] -= drift[static_cast<std::size_t>(i) % drift.size()];
  }
  return system.kineticEnergy(state);
}

/// sum_i |F_i| [N] over the free nodes.
double sumOfForces(const ModelSystem& system, const State& state) {
  std::vector<double> force(state.x.size());
  system.force(state.t, state.x, state.v, state.z, force);
  double sum = 0.0;
  for (int first = 0; first < system.size(); first += system.dimension()) {
    double squares = 0.0;
    for (int i = first; i < first + system.dimension(); ++i) {
      const double component = force[laneOf(system, i)];
      squares += component * component;
    }
    sum += std::sqrt(squares);
  }
  return sum;
}

/// Below this share of the scale a loss is not worth a line.
constexpr double toldLoss = 1e-4;

std::optional<StabilityFunctionLoss> linearLoss(const ModelSystem& system, const std::string& id,
                                                const RunOptions& options) {
  const std::unique_ptr<Integrator> method = makeMethod(id);
  const MethodInfo info = method->info();
  if (!info.implicit || !options.fixedStep || !system.rods().empty()) return std::nullopt;
  const double steps = options.duration / options.h;
  const auto loss = stabilityFunctionLoss(system, *method, system.initialState(), options.h, steps);
  return loss.factor < 1.0 - rounding ? std::optional(loss) : std::nullopt;
}

/// A run is judged by where its steps end: a gain that only interpolated outputs show is none of the motion's, and one
/// that is put together of what the method's own energies allow at switches is none of an unstable step's.
void judgeAtSteps(const ModelSystem& system, const std::string& method, const RunOptions& options,
                  const RunResult& result, const OwnEnergy& own, EnergyBalance& balance) {
  if (!balance.fails()) return;
  const bool interpolated = options.outputInterval != 0.0, switches = own.stable && system.switching() != nullptr;
  if (!interpolated && !switches) return;
  const EnergyClimb climb =
      energyClimb(system, method, options, result.trajectory.t.back(), balance.scale, mostGain * balance.scale, own);
  balance.allowed = climb.allowed;
  if (climb.highest > climb.allowed) {
    balance.highest = std::max(balance.highest, climb.highest);
  } else if (balance.highest > climb.highest && interpolated) {
    balance.interpolated = balance.highest;
    balance.highest = climb.highest;
  }
}

}  // namespace

EnergyFate energyFate(const ModelSystem& system) {
  const Model& model = system.model();
  const bool moved = std::ranges::any_of(model.nodes, [](const ModelNode& node) { return node.motion >= 0; });
  const bool pushed = std::ranges::any_of(model.obstacles, [](const Obstacle& o) { return !o.velocity.isZero(0.0); });
  if (moved || pushed || !model.externalForces.empty()) return EnergyFate::Open;
  const bool complete = system.potential() != nullptr && system.potential()->isComplete();
  return complete ? EnergyFate::Kept : EnergyFate::KeptOrLost;
}

double energyScale(const ModelSystem& system, double way) {
  const State start = system.initialState();
  const MotionFrame frame(system, start);
  double extent = std::max(frame.extent(), wayToObstacles(system.model()));
  if (extent == 0.0) extent = way;
  return kineticEnergyOf(system, start, frame.drift()) + std::abs(system.elasticEnergy(start)) +
         sumOfForces(system, start) * extent;
}

bool EnergyBalance::fails() const {
  return fate != EnergyFate::Open && highest > mostGain * scale && highest > allowed &&
         highest > rounding * (std::abs(start) + std::abs(end) + scale);
}

std::string energyFailure(const EnergyBalance& balance) {
  return fmt::format(
      "the energy rises by {:.3g} J, {:.3g} times the scene's {:.3g} J, where nothing can give any: the step "
      "is too long for this method; take a shorter one",
      balance.highest, balance.scale > 0.0 ? balance.highest / balance.scale : 0.0, balance.scale);
}

std::string energyLoss(const EnergyBalance& balance) {
  if (!balance.linearLoss) return "";
  const StabilityFunctionLoss& loss = *balance.linearLoss;
  return fmt::format(
      "{:.3g} J by the method{}, {:.2g} % of the scene's {:.3g} J; its stability function takes {:.2g} % of the modes "
      "that hold energy at the start, and leaves {:.2g} a step of the fastest (h omega = {:.3g})",
      -balance.end, balance.fate == EnergyFate::Kept ? "" : " and the scene's damping",
      -100.0 * balance.end / balance.scale, balance.scale, 100.0 * loss.share, loss.factor, loss.fastest);
}

EnergyBalance energyBalance(const ModelSystem& system, const std::string& method, const RunOptions& options,
                            const RunResult& result) {
  const std::vector<double>& E = result.trajectory.track("total energy");
  EnergyBalance balance;
  balance.fate = energyFate(system);
  const bool alone = system.nodeCount() == 1;
  balance.scale = energyScale(system, alone ? nodeMotion(system, result.trajectory).position : 0.0);
  balance.start = E.front();
  balance.end = E.back() - E.front();
  for (const double energy : E) {
    balance.highest = std::max(balance.highest, energy - E.front());
    balance.lowest = std::min(balance.lowest, energy - E.front());
  }
  if (balance.fate != EnergyFate::Open && balance.highest > mostGain * balance.scale) {
    const OwnEnergy own = ownEnergy(system, method, options);
    balance.allowed = (own.swing - 1.0) * balance.scale;
    judgeAtSteps(system, method, options, result, own, balance);
  }
  if (balance.fate != EnergyFate::Open && -balance.end > toldLoss * balance.scale) {
    balance.linearLoss = linearLoss(system, method, options);
  }
  return balance;
}

double lostEnergy(const EnergyBalance& balance, const RunResult& finest) {
  if (balance.fate != EnergyFate::Kept) return 0.0;
  const std::vector<double>& E = finest.trajectory.track("total energy");
  const auto late = E.end() - std::max<std::ptrdiff_t>(1, std::ssize(E) / 3);
  return balance.scale > 0.0 ? (E.front() - *std::max_element(late, E.end())) / balance.scale : 0.0;
}

}  // namespace muelle::lab
