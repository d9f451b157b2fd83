#include "engine/statics/equilibrium.h"

#include "base/text/count.h"
#include "engine/compact_system.h"
#include "engine/solve/linear_solver.h"
#include "engine/solve/spans.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The search for a minimum: one object a call of equilibrium().
class Search {
 public:
  Search(const DynamicalSystem& system, const State& start, const StaticOptions& options, StaticResult& result)
      : system_(system), options_(options), result_(result), t_(start.t), z_(start.z) {
    x_ = Eigen::Map<const Vector>(start.x.data(), static_cast<Eigen::Index>(start.x.size()));
    rest_ = Vector::Zero(x_.size());
    radius_ = 0.1 * extent();
    start_ = x_;
    furthest_ = options.furthest > 0.0 ? options.furthest : 1e8 * extent();
  }

  void run();
  const Vector& position() const { return x_; }
  const Vector& force() const { return F_; }
  double roundOff() const { return floor_.size() > 0 ? floor_.maxCoeff() : 0.0; }

 private:
  enum class Outcome { Balanced, Stuck, Exhausted, RanAway };
  /// The point that a step leads to.
  struct Trial {
    double energy = 0.0;   // [J]
    double gain = 0.0;     // of energy, over what was predicted
    bool isSmall = false;  // the energy's digits hardly show what was predicted
    bool isGood = false;
  };

  /// Half the size of the scene, as far as its free nodes tell [m].
  double extent() const { return x_.size() > 0 ? std::max((x_.array() - x_.mean()).abs().maxCoeff(), 1e-3) : 1e-3; }
  double energy(const Vector& x) {
    ++result_.work.forceEvaluations;
    return system_.potential()->energy(t_, spanOf(x), z_);
  }
  void force(const Vector& x, Vector& F) {
    F.resize(x.size());
    ++result_.work.forceEvaluations;
    system_.potential()->conservativeForce(t_, spanOf(x), z_, spanOf(F));
  }
  void assemble();
  bool factorise(double shift);
  bool shiftUntilDefinite();
  bool solve(const Vector& b, Vector& x) {
    ++result_.work.solves;
    return solver_.solve(b, x).empty();
  }
  bool findStep();
  Trial tryStep();
  Outcome balance();
  /// Whether the forces are no larger than what `factor` last bits of the positions do to them.
  bool atRoundOff(double factor) const { return (F_.array().abs() <= factor * floor_.array() + 1e-290).all(); }
  void polish();
  double lowestCurvature(Vector& along);
  bool leave(const Vector& along);

  const DynamicalSystem& system_;
  const StaticOptions& options_;
  StaticResult& result_;
  double t_;
  std::vector<double> z_;
  Vector x_, start_, F_, rest_, trial_, trialF_, step_, floor_, product_, diagonal_;
  double E_ = 0.0;
  double scale_ = 1.0;     // largest entry of the Hessian [N/m]
  double shift_ = 0.0;     // added to its diagonal [N/m]
  double furthest_ = 0.0;  // beyond it nothing holds a node [m]
  double radius_ = 0.0;    // no unknown moves further in a step [m]: nodes should not jump over each other
  SystemMatrix H_;
  LinearSolver solver_;
};

void Search::assemble() {
  system_.linearisation()->assemble(0.0, 0.0, 1.0, t_, spanOf(x_), spanOf(rest_), z_, Form::Symmetric, H_);
  ++result_.work.jacobians;
  diagonal_ = H_.sparse.diagonal();
  const Eigen::Map<const Eigen::ArrayXd> values(H_.sparse.valuePtr(), H_.sparse.nonZeros());
  scale_ = values.size() > 0 ? values.abs().maxCoeff() : 0.0;
  if (!H_.lowRank.empty()) {
    const Vector columns = H_.lowRank.U.cwiseAbs2().colwise().maxCoeff().transpose();
    scale_ = std::max(scale_, columns.cwiseProduct(H_.lowRank.s.cwiseAbs()).maxCoeff());
  }
  // No stiffness at all: the forces over a metre.
  if (!(scale_ > 0.0)) scale_ = std::max(F_.lpNorm<Eigen::Infinity>(), 1e-300);
  multiplyAbsolute(H_, x_, floor_);
  floor_ *= eps;
}

/// Factorises H + shift I; true when that is positive definite.
bool Search::factorise(double shift) {
  H_.sparse.diagonal() = (diagonal_.array() + shift).matrix();
  ++result_.work.factorisations;
  return solver_.factorise(H_, true).usable;
}

bool Search::shiftUntilDefinite() {
  for (int i = 0; i < 40; ++i) {
    if (factorise(shift_)) return true;
    shift_ = std::max(4.0 * shift_, options_.flat * scale_);
  }
  return false;
}

/// Newton steps with the last matrix while each lowers the residual: the last digits.
void Search::polish() {
  for (int i = 0; i < 20; ++i) {
    if (!solve(F_, step_)) return;
    trial_ = x_ + step_;
    force(trial_, trialF_);
    if (!trialF_.allFinite() || !(trialF_.norm() < F_.norm())) return;
    x_.swap(trial_);
    F_.swap(trialF_);
  }
}

/// The step of the matrix as it is shifted, shifted more until it keeps within the radius; false where none can be had.
bool Search::findStep() {
  if (!solve(F_, step_)) return false;
  for (int i = 0; i < 40 && step_.lpNorm<Eigen::Infinity>() > radius_; ++i) {
    shift_ = std::max(8.0 * shift_, options_.flat * scale_);
    if (!factorise(shift_) || !solve(F_, step_)) return false;
  }
  return true;
}

/// What the step comes to, in trial_ and trialF_.
Search::Trial Search::tryStep() {
  const double predicted = 0.5 * (F_.dot(step_) + shift_ * step_.squaredNorm());
  trial_ = x_ + step_;
  force(trial_, trialF_);
  Trial trial;
  trial.energy = energy(trial_);
  const bool finite = trialF_.allFinite() && std::isfinite(trial.energy);
  trial.isSmall = predicted <= 1e-9 * std::abs(E_) + 1e-300;
  trial.gain = finite ? (E_ - trial.energy) / predicted : -1.0;
  // Where the energy has no digits left the residual decides.
  const bool lower = trial.gain > 0.1 && E_ - trial.energy > 16.0 * eps * (std::abs(E_) + std::abs(trial.energy));
  trial.isGood = finite && (lower || (trial.isSmall && trialF_.norm() < F_.norm()));
  return trial;
}

Search::Outcome Search::balance() {
  force(x_, F_);
  E_ = energy(x_);
  int stagnant = 0;
  while (result_.iterations < options_.mostIterations && result_.work.factorisations < options_.mostFactorisations) {
    if ((x_ - start_).lpNorm<Eigen::Infinity>() > furthest_) return Outcome::RanAway;
    ++result_.iterations;
    ++result_.work.newtonIterations;
    assemble();
    if (F_.norm() == 0.0) return Outcome::Balanced;
    if (!shiftUntilDefinite()) return Outcome::Stuck;
    if (atRoundOff(8.0)) {
      polish();
      return Outcome::Balanced;
    }
    if (!findStep()) return Outcome::Stuck;
    const Trial trial = tryStep();
    if (trial.isGood) {
      x_.swap(trial_);
      F_.swap(trialF_);
      E_ = trial.energy;
      if (trial.gain > 0.7) radius_ *= 2.0;
      if (trial.gain > 0.7 || trial.isSmall) shift_ = shift_ <= options_.flat * scale_ ? 0.0 : 0.1 * shift_;
      stagnant = 0;
      continue;
    }
    if (trial.isSmall && atRoundOff(1e3)) {
      polish();
      return Outcome::Balanced;
    }
    shift_ = std::max(4.0 * shift_, 1e-6 * scale_);
    radius_ = 0.5 * step_.lpNorm<Eigen::Infinity>();
    if (++stagnant > 60) return Outcome::Stuck;
  }
  return Outcome::Exhausted;
}

/// Smallest eigenvalue of H and its eigenvector, by inverse iteration with the smallest shift that makes it positive
/// definite (within a factor of 1.1 when there is a negative eigenvalue).
double Search::lowestCurvature(Vector& along) {
  assemble();
  double low = 0.0, high = options_.flat * scale_;
  while (!factorise(high) && high < 1e6 * scale_) {
    low = high;
    high *= 8.0;
  }
  for (int i = 0; i < 6 && low > 0.0; ++i) {
    const double middle = std::sqrt(low * high);
    (factorise(middle) ? high : low) = middle;
  }
  if (!factorise(high)) return std::numeric_limits<double>::quiet_NaN();
  along.resize(x_.size());
  for (Eigen::Index i = 0; i < along.size(); ++i) along[i] = 1.0 + 0.5 * std::sin(1.7 * static_cast<double>(i));
  along.normalize();
  Vector next(x_.size());
  double value = 0.0;
  for (int i = 0; i < 200; ++i) {
    if (!solve(along, next)) break;
    const double inverse = along.dot(next);
    const double now = 1.0 / inverse - high;
    along = next.normalized();
    if (i > 2 && std::abs(now - value) <= 1e-8 * std::abs(now + high)) {
      value = now;
      break;
    }
    value = now;
  }
  factorise(0.0);
  return value;
}

/// Goes down from a saddle, as far as doubling the way helps; false when the energy does not fall.
bool Search::leave(const Vector& along) {
  const double sign = F_.dot(along) < 0.0 ? -1.0 : 1.0;
  double way = sign * 1e-4 * extent() / along.lpNorm<Eigen::Infinity>();
  double lowest = energy(x_ + way * along);
  for (int i = 0; i < 30 && !(lowest < E_); ++i) {
    way *= 0.5;
    lowest = energy(x_ + way * along);
  }
  if (!(lowest < E_)) return false;
  for (int i = 0; i < 30; ++i) {
    const double further = energy(x_ + 2.0 * way * along);
    if (!(further < lowest)) break;
    way *= 2.0;
    lowest = further;
  }
  x_ += way * along;
  shift_ = 0.0;
  radius_ = std::max(0.1 * extent(), std::abs(way) * along.lpNorm<Eigen::Infinity>());
  return true;
}

void Search::run() {
  for (;;) {
    const Outcome outcome = balance();
    if (outcome == Outcome::Exhausted) {
      result_.message = "no equilibrium after " + counted(result_.iterations, "iteration");
      return;
    }
    if (outcome == Outcome::RanAway) {
      result_.ranAway = true;
      result_.message = "nothing holds the nodes: the energy falls without end";
      return;
    }
    result_.balanced = outcome == Outcome::Balanced;
    if (!options_.judge) {
      result_.message = result_.balanced ? "the forces balance" : "no step lowers the energy";
      return;
    }
    // Stuck: so close to a saddle that the energy does not show the way down, its curvature does.
    Vector along;
    result_.smallestEigenvalue = lowestCurvature(along);
    const double flat = 10.0 * options_.flat * scale_;
    if (std::isnan(result_.smallestEigenvalue)) {
      result_.message = "the stiffness matrix cannot be factorised with any shift";
      return;
    }
    if (result_.smallestEigenvalue >= -flat) {
      result_.converged = outcome == Outcome::Balanced;
      result_.message = !result_.converged ? "no step lowers the energy, and the forces do not balance"
                        : result_.smallestEigenvalue > flat
                            ? "a minimum of the energy"
                            : "a minimum of the energy, flat in at least one direction (mechanism or rigid motion)";
      return;
    }
    if (!options_.leaveSaddles || result_.saddlesLeft >= 100 || !leave(along)) {
      result_.message = fmt::format("a saddle of the energy: curvature {:.3g} N/m", result_.smallestEigenvalue);
      return;
    }
    ++result_.saddlesLeft;
  }
}

void check(const DynamicalSystem& system, const State& start) {
  if (system.potential() == nullptr || system.linearisation() == nullptr) {
    throw std::invalid_argument("an equilibrium needs the energy of the forces (potential) and its derivatives");
  }
  if (!system.rods().empty()) {
    throw std::invalid_argument("an equilibrium with rods is not looked for: give the springs a stiffness k");
  }
  if (start.x.size() != static_cast<std::size_t>(system.storage())) {
    throw std::invalid_argument(fmt::format("equilibrium: {} for {}", counted(std::ssize(start.x), "position"),
                                            counted(system.storage(), "lane")));
  }
  const auto bad = std::ranges::find_if(start.x, [](double x) { return !std::isfinite(x); });
  if (bad != start.x.end()) {
    const auto lane = static_cast<int>(bad - start.x.begin());
    throw std::invalid_argument(fmt::format("equilibrium: position {} is not finite", laneName(system, lane)));
  }
}

}  // namespace

StaticResult equilibrium(const DynamicalSystem& system, State start, const StaticOptions& options) {
  check(system, start);
  start.v.assign(start.x.size(), 0.0);
  if (start.z.size() != static_cast<std::size_t>(system.internalSize())) {
    start.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
    if (system.switching() != nullptr) system.switching()->commit(start, false);
  }
  StaticResult result;
  CompactSystem compact(system);
  compact.follow(start);
  State end = compact.compact(start);
  Search search(compact, end, options, result);
  search.run();

  const Vector& x = search.position();
  const Vector& F = search.force();
  result.state = std::move(start);
  std::ranges::copy(x, end.x.begin());
  compact.expand(end, result.state);
  result.energy = system.potential()->energy(result.state.t, result.state.x, result.state.z);
  result.roundOff = search.roundOff();
  const int dimension = system.dimension();
  for (Eigen::Index i = 0; i + dimension <= F.size(); i += dimension) {
    result.nodeResiduals.push_back(F.segment(i, dimension).norm());
    result.residual = std::max(result.residual, result.nodeResiduals.back());
  }
  Vector all(F.size());
  compact.force(end.t, end.x, end.v, end.z, spanOf(all));
  if (!result.converged && !result.nodeResiduals.empty()) {
    const auto worst = std::ranges::max_element(result.nodeResiduals) - result.nodeResiduals.begin();
    result.message += fmt::format("; largest sum of forces {:.3g} N at {}", result.residual,
                                  system.unknownName(static_cast<int>(worst) * dimension));
  }
  result.unbalanced = F.size() > 0 ? (all - F).lpNorm<Eigen::Infinity>() : 0.0;
  return result;
}

}  // namespace muelle::engine
