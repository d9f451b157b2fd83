#include "lab/hard_cases/sensitivity.h"

#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/variant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muelle::hard_cases {

namespace {

constexpr int samples = 8;
constexpr int fewUnknowns = 6;
constexpr double change = 1e-7;  // [m]: far above the run's own error, small enough to be linear

/// Accurate, adaptive, and at home with velocities and contacts.
constexpr const char* accurate = "dop853";

engine::RunOptions referenceOptions(const Variant& variant, double duration) {
  engine::RunOptions options = withTolerance(std::min(1e-10, variant.steps.tolerance), duration);
  options.mostForceEvaluations = 1'000'000;
  return options;
}

/// Goes on from a state to the variant's end, and returns its number there.
double numberAfter(const Variant& variant, const State& state) {
  Finished end;
  end.system = engine::build(variant.model);
  const auto method = engine::makeMethod(accurate);
  end.result = engine::simulate(*end.system, *method, state, referenceOptions(variant, variant.duration - state.t));
  return end.result.failed() ? std::numeric_limits<double>::infinity() : variant.error(end);
}

/// The fastest rate of the motions that matter [1/s]: it makes a velocity comparable with a position.
double rateOf(const Variant& variant) {
  double rate = 0.0, largest = 0.0;
  for (const Mode& m : variant.modes) {
    const double size = std::max(m.amplitude, std::abs(m.speed));
    if (size <= largest) continue;
    largest = size;
    rate = std::sqrt(std::abs(m.stiffness));
  }
  return rate > 0.0 ? rate : 1.0;
}

double speedOf(const State& state) {
  double largest = 0.0;
  for (const double v : state.v) largest = std::max(largest, std::abs(v));
  return largest;
}

/// Changes of 1 m, velocities in units of the rate: along each unknown while there are few. Of many only those that the
/// motion itself makes, in the places alone and in the velocities alone: any other would stretch what is stiff.
std::vector<State> directions(const Variant& variant, const engine::ModelSystem& system, const State& state) {
  const std::size_t n = state.x.size();
  const double rate = rateOf(variant);
  std::vector<State> all;
  const State none{0.0, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0), {}};
  if (system.size() > fewUnknowns) {
    all.assign(2, none);
    const double fastest = std::max(speedOf(state), 1e-300);
    for (std::size_t i = 0; i < n; ++i) {
      all[0].x[i] = state.v[i] / fastest;
      all[1].v[i] = rate * state.v[i] / fastest;
    }
    return all;
  }
  for (int i = 0; i < system.size(); ++i) {
    const std::size_t lane = laneOf(system, i);
    all.push_back(none);
    all.back().x[lane] = 1.0;
    all.push_back(none);
    all.back().v[lane] = rate;
  }
  return all;
}

double growthFrom(const Variant& variant, const engine::ModelSystem& system, const State& state) {
  double sum = 0.0;
  const std::vector<State> all = directions(variant, system, state);
  for (const State& direction : all) {
    State moved = state;
    for (std::size_t i = 0; i < moved.x.size(); ++i) {
      moved.x[i] += change * direction.x[i];
      moved.v[i] += change * direction.v[i];
    }
    const double growth = numberAfter(variant, moved) / change;
    sum += growth * growth;
  }
  return std::sqrt(sum / static_cast<double>(all.size()));
}

double growthPerSpeed(const Variant& variant, State state) {
  constexpr double part = 1e-7;
  for (double& v : state.v) v *= 1.0 + part;
  return numberAfter(variant, state) / part;
}

/// Speed of the motion at a state, velocities and accelerations over the rate, of the unknown that moves most [m/s].
double flowOf(const Variant& variant, const engine::ModelSystem& system, const State& state) {
  std::vector<double> acceleration(state.x.size());
  State live = state;
  if (live.z.empty()) live.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  if (system.switching() != nullptr) system.switching()->commit(live, false);
  system.acceleration(live.t, live.x, live.v, live.z, acceleration);
  double largest = 0.0;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    largest = std::max(largest, std::hypot(state.v[i], acceleration[i] / rateOf(variant)));
  }
  return largest;
}

/// How fast the variant's number changes with the end of the run [1/s].
double numberPerSecond(const Variant& variant, const engine::ModelSystem& system) {
  const double early = 1e-5 * variant.duration;
  Finished end;
  end.system = engine::build(variant.model);
  end.result = engine::simulate(*end.system, *engine::makeMethod(accurate), system.initialState(),
                                referenceOptions(variant, variant.duration - early));
  return variant.error(end) / early;
}

engine::RunResult referenceRun(const Variant& variant, const engine::ModelSystem& system) {
  engine::RunOptions options = referenceOptions(variant, variant.duration);
  options.keepStates = true;
  options.outputInterval = variant.duration / (2.0 * samples);
  return engine::simulate(system, *engine::makeMethod(accurate), system.initialState(), options);
}

}  // namespace

Sensitivity::Growth Sensitivity::between(double from, double to) const {
  if (times.empty()) return {};
  double sumAny = 0.0, sumAlong = 0.0, count = 0.0;
  std::size_t nearest = 0;
  for (std::size_t j = 0; j < times.size(); ++j) {
    if (std::abs(times[j] - to) < std::abs(times[nearest] - to)) nearest = j;
    if (times[j] < from || times[j] > to) continue;
    sumAny += any[j] * any[j];
    sumAlong += along[j] * along[j];
    count += 1.0;
  }
  if (count == 0.0) return {any[nearest], along[nearest]};
  return {std::sqrt(sumAny / count), std::sqrt(sumAlong / count)};
}

double extentOf(const Variant& variant) {
  const auto system = engine::build(variant.model);
  const Trajectory motion = referenceRun(variant, *system).trajectory;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t k = 0; k < motion.t.size(); ++k) {
    const State state{motion.t[k], motion.x[k], motion.v[k], {}};
    for (int node = 0; node < system->nodeCount(); ++node) {
      low = low.cwiseMin(system->position(state, node));
      high = high.cwiseMax(system->position(state, node));
    }
  }
  return (high - low).norm();
}

Sensitivity sensitivityOf(const Variant& variant) {
  const auto system = engine::build(variant.model);
  const engine::RunResult result = referenceRun(variant, *system);
  const Trajectory& motion = result.trajectory;
  Sensitivity found;
  found.endSpeed = speedOf(result.last);
  std::vector<State> states;
  double fastest = 0.0;
  for (std::size_t k = 1; k + 1 < motion.t.size(); k += 2) {
    states.push_back({motion.t[k], motion.x[k], motion.v[k], {}});
    fastest = std::max(fastest, speedOf(states.back()));
  }
  const double perSecond = numberPerSecond(variant, *system);
  double sum = 0.0;
  int fast = 0;
  for (const State& state : states) {
    found.times.push_back(state.t);
    found.any.push_back(growthFrom(variant, *system, state));
    found.along.push_back(perSecond / flowOf(variant, *system, state));
    if (speedOf(state) < 0.5 * fastest) continue;
    const double growth = growthPerSpeed(variant, state);
    sum += growth * growth;
    ++fast;
  }
  found.perRelativeSpeed = fast > 0 ? std::sqrt(sum / fast) : 0.0;
  return found;
}

}  // namespace muelle::hard_cases
