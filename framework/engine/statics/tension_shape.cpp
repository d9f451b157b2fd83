#include "engine/statics/tension_shape.h"

#include "engine/forces/length.h"
#include "engine/model/axes.h"
#include "engine/solve/spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
/// k over rho from which on a tension is an unknown: below, the positions know it to 1e-16 x 100 and the matrix is as
/// good without.
constexpr double stiff = 10.0;
/// A balance that round-off spoils more than this, of the largest force, is none.
constexpr double trusted = 1e-6;
/// Strains below are round-off of the positions: there are no tensions to be solved for.
constexpr double leastStrain = 1e-14;

std::unique_ptr<ModelSystem> withoutSprings(const ModelSystem& system) {
  Model model = system.model();
  // Kept with no stiffness: so the unknowns have the numbers, and the matrix the pattern, of the whole.
  for (ModelSpring& spring : model.springs) spring.k = 0.0;
  return build(model);
}

/// The springs of a model that have a free node, the fixed ends where they are in `state`.
std::vector<TensionSpring> springsOf(const ModelSystem& system, const State& state) {
  const Model& model = system.model();
  const std::vector<int> axes = axesOf(model);
  const auto compact = [&](int node) {
    const Vec3 full = system.position(state, node);
    Vec3 own = Vec3::Zero();
    for (std::size_t c = 0; c < axes.size(); ++c) own[static_cast<Eigen::Index>(c)] = full[axes[c]];
    return own;
  };
  std::vector<TensionSpring> all;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& s = model.springs[i];
    TensionSpring spring;
    spring.spring = i;
    spring.a = system.unknown(s.a, axes[0]);
    spring.b = system.unknown(s.b, axes[0]);
    if (spring.a < 0 && spring.b < 0) continue;
    spring.fixedA = compact(s.a);
    spring.fixedB = compact(s.b);
    spring.k = s.k;
    spring.L0 = s.L0;
    spring.onlyPushes = s.unilateral;
    all.push_back(spring);
  }
  return all;
}

}  // namespace

double difference(double a, double b, double& rest) {
  const double s = a - b;
  const double part = s - a;
  rest = (a - (s - part)) + (-b - part);
  return s;
}

TensionShape::TensionShape(const ModelSystem& whole, const State& state)
    : system(whole),
      others(withoutSprings(whole)),
      still(*others, state.t),
      compact(still),
      start(state),
      dimension(whole.dimension()),
      size(whole.size()) {
  std::ranges::fill(start.v, 0.0);
  compact.follow(start);
  springs = springsOf(system, start);
  put(start.x);
  for (Eigen::Index i = 0; i + dimension <= size; i += dimension) load += otherForce.segment(i, dimension).norm();
}

void TensionShape::put(In x) {
  hi.resize(size);
  compact.gather(x, spanOf(hi));
  lo = Vector::Zero(size);
  for (TensionSpring& spring : springs) spring.mixed = false;
  measure();
}

void TensionShape::measureLengths() {
  for (TensionSpring& spring : springs) {
    Vec3 d = Vec3::Zero();
    for (Eigen::Index c = 0; c < dimension; ++c) {
      const double a = spring.a < 0 ? spring.fixedA[c] : hi[spring.a + c];
      const double b = spring.b < 0 ? spring.fixedB[c] : hi[spring.b + c];
      const double aRest = spring.a < 0 ? 0.0 : lo[spring.a + c];
      const double bRest = spring.b < 0 ? 0.0 : lo[spring.b + c];
      double rest = 0.0;
      const double first = difference(a, b, rest);
      d[c] = first + (rest + (aRest - bRest));
    }
    spring.L = length<3>(d);
    spring.n = spring.L > 0.0 ? Vec3(d / spring.L) : Vec3(Vec3::Zero());
  }
}

void TensionShape::addSpringForces() {
  for (const TensionSpring& spring : springs) {
    // One that just does not push would with the next bit.
    if (!spring.acts() && !(spring.onlyPushes && spring.L <= (1.0 + 1e-12) * spring.L0)) continue;
    const double T = spring.tension();
    for (Eigen::Index c = 0; c < dimension; ++c) {
      const double pull = T * spring.n[c];
      if (spring.a >= 0) F[static_cast<std::size_t>(spring.a + c)] -= pull;
      if (spring.b >= 0) F[static_cast<std::size_t>(spring.b + c)] += pull;
      // A spring that acts by its position knows its tension to what its length does.
      const double bits = std::abs(pull) + spring.stiffness() * spring.L * std::abs(spring.n[c]);
      if (spring.a >= 0) floor[spring.a + c] += bits;
      if (spring.b >= 0) floor[spring.b + c] += bits;
    }
  }
}

void TensionShape::measure() {
  measureLengths();
  ++work.forceEvaluations;
  otherForce.resize(size);
  compact.potential()->conservativeForce(start.t, spanOf(hi), start.z, spanOf(otherForce));
  F.assign(otherForce.data(), otherForce.data() + size);
  floor = otherForce.cwiseAbs();
  addSpringForces();
  floor *= eps;
  if (otherFloor.size() == size) floor += otherFloor;
}

void TensionShape::chooseUnknownTensions() {
  double across = 0.0;  // largest T/L [N/m]
  double lengths = 0.0, stiffest = 0.0;
  for (const TensionSpring& spring : springs) {
    stiffest = std::max(stiffest, spring.k);
    if (spring.L > 0.0) across = std::max(across, std::abs(spring.tension()) / spring.L);
    lengths += spring.L;
  }
  typicalLength = springs.empty() || !(lengths > 0.0) ? 1.0 : lengths / static_cast<double>(springs.size());
  // Where the start says nothing yet: what one spring would be strained that carries all.
  across = std::max(across, load / typicalLength);
  const double rho = keptStiffness * across;
  const bool strained = across > leastStrain * stiffest;
  for (TensionSpring& spring : springs) {
    const double T = spring.tension();
    spring.mixed = !spring.onlyPushes && strained && spring.k > stiff * rho && spring.L > 0.0;
    spring.rho = spring.mixed ? rho : 0.0;
    spring.S = spring.mixed ? T - rho * (spring.L - spring.L0) : 0.0;
  }
}

Imbalance TensionShape::imbalance() const {
  Imbalance result;
  result.atRoundOff = true;
  double sumForce = 0.0, sumLength = 0.0;
  int mixed = 0;
  const Eigen::Index nodes = size / dimension;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const Eigen::Map<const Vector> sum(F.data() + dimension * i, dimension);
    const double bits = floor.segment(dimension * i, dimension).norm();
    const double force = length<3>(Vec3(sum[0], dimension > 1 ? sum[1] : 0.0, dimension > 2 ? sum[2] : 0.0));
    if (!(force <= result.force)) {
      result.force = force;
      result.forceFloor = bits;
      result.worstUnknown = static_cast<int>(dimension * i);
    }
    if (!(force <= 64.0 * bits + 1e-290)) result.atRoundOff = false;
    sumForce += force * force;
  }
  for (const TensionSpring& spring : springs) {
    if (!spring.mixed) continue;
    ++mixed;
    const double error = std::abs(spring.lengthError());
    result.length = std::max(result.length, error);
    if (!(error <= 16.0 * eps * (spring.L + spring.L0))) result.atRoundOff = false;
    sumLength += error * error;
  }
  // Where round-off is as large as the forces themselves, as beside a singular place, nothing balances.
  double forces = load, stiffest = 0.0;
  for (const TensionSpring& spring : springs) {
    forces = std::max(forces, std::abs(spring.tension()));
    stiffest = std::max(stiffest, spring.k * spring.L);
  }
  if (!(result.force <= trusted * forces + 64.0 * eps * stiffest)) result.atRoundOff = false;
  if (mixed == 0) result.length = -1.0;
  const double unit = load > 0.0 ? load / static_cast<double>(std::max<Eigen::Index>(nodes, 1)) : 1.0;
  result.merit = std::sqrt(sumForce / static_cast<double>(std::max<Eigen::Index>(nodes, 1))) / unit +
                 (mixed > 0 ? std::sqrt(sumLength / mixed) / typicalLength : 0.0);
  return result;
}

}  // namespace muelle::engine
