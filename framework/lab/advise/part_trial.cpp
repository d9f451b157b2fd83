#include "lab/advise/part_trial.h"

#include "engine/model/axes.h"
#include "lab/advise/countdown.h"
#include "lab/advise/method_search.h"
#include "lab/bench/statistics.h"
#include "lab/run/energy_balance.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace muelle::lab {

using namespace engine;

namespace {

/// What parts may change, in parts of the tolerance.
constexpr double ofTolerance = 1.0 / 3.0;

/// At so many states of the run stiffness is looked at.
constexpr std::size_t mostStates = 60;

/// Digits are given up for time alone: a model without them is no easier to look at.
constexpr double worthDigits = 0.95;

/// A disturbance that grows more is not left to chance.
constexpr double mostGrowth = 100.0;

/// The most negative stiffness of a mode along an axis at any of the states, in parts of the largest; with the time.
struct Buckling {
  double worst = 0.0, t = 0.0;
};

Buckling bucklingAlong(const ModelSystem& system, const std::vector<State>& states, int axis) {
  Buckling found;
  std::mt19937 dice(5);
  const std::size_t stride = 1 + states.size() / mostStates;
  for (std::size_t i = 0; i < states.size(); i += stride) {
    const State& state = states[i];
    const LinearisedSystem linearised(system, state);
    std::vector<double> y(static_cast<std::size_t>(linearised.size()), 0.0);
    for (int node = 0; node < system.nodeCount(); ++node) {
      const int unknown = system.unknown(node, axis);
      if (unknown >= 0) y[static_cast<std::size_t>(unknown)] = static_cast<double>(dice() % 2001) / 1000.0 - 1.0;
    }
    // In a plane the stiffness across it stands alone: a Krylov space of y never leaves the axis.
    double least = 0.0, most = 0.0;
    for (const Mode& mode : modesOf(linearised, y, 40)) {
      least = std::min(least, mode.stiffness);
      most = std::max(most, std::abs(mode.stiffness));
    }
    for (const Mode& mode : extremeModes(linearised)) most = std::max(most, std::abs(mode.stiffness));
    if (most > 0.0 && least / most < found.worst) found = {least / most, state.t};
  }
  return found;
}

/// How far a node can come in the whole run [m], from the energy alone: with what the scene has at the start, and what
/// gravity gives on the way to all of it, the lightest node flies at v with m v^2 / 2 = E + M g s, and ds/dt <= v makes
/// s = v0 T + (M g / m) T^2 / 2. Infinite where something drives the scene.
double reachByEnergy(const Scene& scene, const ModelSystem& system) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  if (energyFate(system) == EnergyFate::Open) return unbounded;
  const State start = system.initialState();
  double lightest = unbounded, all = 0.0;
  for (const ModelNode& node : scene.model.nodes) {
    if (!isFree(node)) continue;
    lightest = std::min(lightest, node.m);
    all += node.m;
  }
  const double energy = system.kineticEnergy(start) + system.elasticEnergy(start);
  const double pull = all * scene.model.gravity.norm() / lightest;
  return std::sqrt(2.0 * energy / lightest) * scene.duration + 0.5 * pull * scene.duration * scene.duration;
}

/// A setting whose own error is a small part of what this one's is, and no finer: where digits are missing an error
/// estimate far below what they can tell is noise, to which no step is short enough.
Setting finer(Setting setting) {
  setting.value /= setting.fixed ? 4.0 : 30.0;
  return setting;
}

class Trials {
 public:
  Trials(const Pilots& whole, const ReferenceMotion& reference, const Setting& timing, double tolerance, double seconds)
      : whole_(whole), reference_(reference), timing_(timing), tolerance_(tolerance), clock_(seconds) {}

  PartTrial of(const Simplification& part) {
    PartTrial trial;
    trial.part = part;
    if (clock_.left() <= 0.0) {
      trial.why = "the time was over";
      return trial;
    }
    const Scene rest = without(whole_.scene(), {part});
    std::unique_ptr<ModelSystem> system;
    try {
      system = build(rest.model);
    } catch (const std::invalid_argument& problem) {
      trial.why = fmt::format("what is left is no model: {}", problem.what());
      return trial;
    }
    const Pilots pilots(rest, *system);
    const PilotRun run = pilots.run(
        part.kind == Simplification::Kind::Digits ? finer(timing_) : reference_.run.setting,
        {.seconds = clock_.left(), .ofProcessor = std::max(0.2, 5.0 * reference_.run.seconds), .isReference = true});
    if (!run.done()) {
      trial.why = "without it: " + run.failure;
      return trial;
    }
    trial.error = statedError(reference_.errorOf(whole_, run.rows), reference_.doubt);
    time(pilots, trial);
    decide(trial);
    return trial;
  }

 private:
  void time(const Pilots& pilots, PartTrial& trial) {
    if (!refusalOf(pilots.system(), timing_.method).empty()) return;
    std::vector<double> ratios;
    for (int round = 0; round < 5 && (round == 0 || clock_.left() > 0.0); ++round) {
      const double with = whole_.bareSeconds(timing_);
      ratios.push_back(pilots.bareSeconds(timing_) / with);
    }
    trial.timeLeft = bench::statisticsOf(ratios).median;
    trial.measured = true;
  }

  void decide(PartTrial& trial) {
    if (trial.part.kind == Simplification::Kind::Contact && touched(trial)) return;
    if (!(trial.error <= ofTolerance * tolerance_)) {
      trial.why = fmt::format("without it the error is {:.2g}", trial.error);
      return;
    }
    if (trial.part.kind == Simplification::Kind::Axis && !isFlat(trial)) return;
    if (trial.part.kind == Simplification::Kind::Digits && !(trial.measured && trial.timeLeft < worthDigits)) {
      trial.why = "it would hardly be faster";
      return;
    }
    trial.leftOut = true;
    if (trial.why.empty()) trial.why = "over the whole run it changes no more";
  }

  bool touched(PartTrial& trial) const {
    const std::size_t i = trial.part.obstacle;
    const double touch = reference_.run.firstTouch[i], gap = reference_.run.sureGap[i];
    if (std::isfinite(touch)) {
      trial.why = fmt::format("it is touched at {:.3g} s", touch);
      return true;
    }
    if (gap <= 2.0 * tolerance_ * reference_.run.motion.position) {
      trial.why = fmt::format("a node comes as near as {:.2g} m", std::max(0.0, gap));
      return true;
    }
    const double reach = reachByEnergy(whole_.scene(), whole_.system());
    const double first = reference_.run.startGap[i];
    const bool stands = whole_.scene().model.obstacles[i].velocity.norm() == 0.0;
    trial.why =
        stands && reach < first
            ? fmt::format("by its energy no node comes farther than {:.2g} m, and the gap is {:.2g} m", reach, first)
            : fmt::format("no node comes nearer than {:.2g} m, and none touches it in the run that is advised", gap);
    return false;
  }

  /// Whether a 3D scene stays flat by itself, not by chance.
  bool isFlat(PartTrial& trial) const {
    const std::vector<int> lost = trial.part.dimension == 2 ? std::vector<int>{trial.part.axis} : acrossX();
    for (const int axis : lost) {
      const Buckling buckling = bucklingAlong(whole_.system(), reference_.run.states, axis);
      if (buckling.worst < -1e-10) {
        trial.why =
            fmt::format("it may buckle along {}: at {:.3g} s forces push away from the plane", "xyz"[axis], buckling.t);
        return false;
      }
      const double growth = growthOf(whole_, reference_, axis, clock_.left());
      if (!(growth <= mostGrowth)) {
        trial.why = std::isfinite(growth)
                        ? fmt::format("a small disturbance along {} grows {:.2g} times", "xyz"[axis], growth)
                        : fmt::format("the time was over before a disturbance along {} was followed", "xyz"[axis]);
        return false;
      }
      trial.why = fmt::format("nothing pushes along {}, and a disturbance there grows {:.2g} times at most",
                              "xyz"[axis], growth);
    }
    return true;
  }
  std::vector<int> acrossX() const {
    std::vector<int> axes = axesOf(whole_.scene().model);
    std::erase(axes, 0);
    return axes;
  }

  const Pilots& whole_;
  const ReferenceMotion& reference_;
  Setting timing_;
  double tolerance_;
  Countdown clock_;
};

/// Nodes that never move more than a thirtieth of what is allowed.
std::vector<Simplification> stillNodes(const Scene& scene, const ReferenceMotion& reference, double tolerance) {
  Simplification part{.kind = Simplification::Kind::Motion, .name = ""};
  const PathRows& rows = reference.run.rows;
  const double most = tolerance / 30.0 * reference.run.motion.position;
  int unknown = 0;
  for (std::size_t node = 0; node < scene.model.nodes.size(); ++node) {
    if (!isFree(scene.model.nodes[node])) continue;
    ++unknown;
    const Vec3& start = scene.model.nodes[node].x;
    const bool still = std::ranges::all_of(rows.x, [&](const std::vector<double>& x) {
      return (Vec3(x[3 * node], x[3 * node + 1], x[3 * node + 2]) - start).norm() <= most;
    });
    if (still) part.nodes.push_back(static_cast<int>(node));
  }
  if (part.nodes.empty() || std::ssize(part.nodes) == unknown) return {};
  part.name = part.nodes.size() == 1 ? fmt::format("motion of node {}", part.nodes[0])
                                     : fmt::format("motion of {} still nodes", part.nodes.size());
  return {part};
}

}  // namespace

std::vector<PartTrial> tryParts(const Pilots& whole, const ReferenceMotion& reference, const Setting& timing,
                                double tolerance, double seconds) {
  Trials trials(whole, reference, timing, tolerance, seconds);
  std::vector<PartTrial> all;
  for (const Simplification& part : simplificationsOf(whole.scene())) all.push_back(trials.of(part));
  for (const Simplification& part : stillNodes(whole.scene(), reference, tolerance)) all.push_back(trials.of(part));
  if (whole.system().mayBeSingle() && whole.scene().model.precision == kernels::Precision::Double) {
    all.push_back(trials.of({.kind = Simplification::Kind::Digits, .name = "double precision"}));
  }
  return all;
}

std::vector<Simplification> leaveOutTogether(const Pilots& whole, const ReferenceMotion& reference,
                                             std::vector<PartTrial>& trials, double tolerance, double seconds) {
  const Countdown clock(seconds);
  while (true) {
    std::vector<Simplification> parts, followed;
    double ofDigits = 0.0;  // found by runs of their own, see finer(); errors add at most
    PartTrial* largest = nullptr;
    for (PartTrial& trial : trials) {
      if (!trial.leftOut) continue;
      parts.push_back(trial.part);
      if (trial.part.kind == Simplification::Kind::Digits) {
        ofDigits += trial.error;
      } else {
        followed.push_back(trial.part);
      }
      if (largest == nullptr || trial.error > largest->error) largest = &trial;
    }
    if (parts.size() < 2) return parts;
    const Scene rest = without(whole.scene(), followed);
    const std::unique_ptr<ModelSystem> system = build(rest.model);
    const PilotRun run =
        Pilots(rest, *system).run(reference.run.setting, {.seconds = clock.left(), .isReference = true});
    const double error =
        run.done() ? statedError(reference.errorOf(whole, run.rows), reference.doubt) + ofDigits : INFINITY;
    if (error <= ofTolerance * tolerance) return parts;
    largest->leftOut = false;
    largest->why = run.outOfTime ? "the time was over" : "with the other parts it changes too much";
  }
}

}  // namespace muelle::lab
