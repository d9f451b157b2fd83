#include "base/text/count.h"
#include "engine/integrators/position_based/methods.h"
#include "engine/integrators/position_based/position_method.h"
#include "engine/solve/linear_solver.h"

#include <fmt/format.h>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

MethodInfo projectiveDynamicsInfo(int iterations) {
  MethodInfo info =
      positionBasedInfo("projective_dynamics", "projective dynamics, " + counted(iterations, "iteration"));
  info.needs.distanceConstraints = true;
  info.formula = "(M / h^2 + sum k A^T A) x = M s / h^2 + sum k A^T p,  s = x0 + h v0 + h^2 M^-1 F_ext,  |p| = L0";
  info.source = "Bouaziz et al.: Projective Dynamics, 2014; Liu et al. 2013 for springs";
  info.remark =
      "A baseline: the local-global iteration tends to backward Euler's solution slowly when springs turn, and "
      "stopping "
      "early looks like slow motion. Distances only.";
  return info;
}

/// The local step projects each spring on its rest length, the global step solves with a constant matrix, factorised
/// once for each h. Written for the increment of x: the right-hand side is then the true residual of backward Euler
/// (projected damping included), and only the matrix is the method's.
class ProjectiveDynamics final : public PositionMethod {
 public:
  explicit ProjectiveDynamics(int iterations)
      : PositionMethod(projectiveDynamicsInfo(iterations)), iterations_(iterations) {
    if (iterations < 1) {
      throw std::invalid_argument(
          fmt::format("projective_dynamics: {}; at least 1 is needed", counted(iterations, "iteration")));
    }
  }

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override {
    PositionMethod::prepare(system, tolerance);
    matrixStep_ = 0.0;
    covered_.assign(static_cast<std::size_t>(system.constraints()->count()), false);
    for (Vector* v : {&residual_, &increment_, &offset_}) v->setZero(system.storage());
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    to.x = from.x;
    to.v = from.v;
    to.z = from.z;
    accelerate(system, from.t, h, to);
    for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] += h * to.v[i];
    system.place(from.t + h, to.z, to.x, to.v);
    // The distance from the inertial position is kept by itself: a difference of positions, divided by h, would bring
    // their rounding into the momentum.
    offset_.setZero();
    const Eigen::Map<const Vector> m(mass_.data(), offset_.size());
    Eigen::Map<Vector> x(to.x.data(), offset_.size());
    for (int i = 0; i < iterations_; ++i) {
      residual_ = m.cwiseProduct(offset_) / (h * h);
      if (addElastic(system, from, h, to) || h != matrixStep_) {
        const std::string failure = refactor(system, from.t + h, h, to);
        if (!failure.empty()) return {.done = false, .failure = failure};
      }
      const std::string failure = solver_.solve(residual_, increment_);
      ++work_.solves;
      if (!failure.empty()) return {.done = false, .failure = fmt::format("{}: {}", info_.id, failure)};
      x -= increment_;
      offset_ -= increment_;
    }
    Eigen::Map<Vector>(to.v.data(), offset_.size()) += offset_ / h;
    return finish(from, h, to);
  }

  void restart() override { matrixStep_ = 0.0; }

 private:
  /// Adds the gradient of the springs' energies and their damping to residual_; true when one acts that the matrix
  /// lacks.
  bool addElastic(const DynamicalSystem& system, const State& from, double h, const State& to) {
    ++work_.forceEvaluations;
    bool missing = false;
    const auto add = [&](std::span<const Constraint> constraints) {
      for (const Constraint& c : constraints) {
        if (!covered_[static_cast<std::size_t>(c.index)]) missing = true;
        addElastic(c, from, h, to);
      }
    };
    system.constraints()->evaluate(from.t + h, to.x, to.z, std::ref(add));
    return missing;
  }

  void addElastic(const Constraint& c, const State& from, double h, const State& to) {
    const auto entries = static_cast<std::size_t>(c.count);
    double moved = 0.0;
    for (std::size_t i = 0; i < entries; ++i) {
      const auto u = static_cast<std::size_t>(c.lane[i]);
      if (isFree(c.lane[i])) moved += c.gradient[i] * (to.x[u] - from.x[u]);
    }
    const double pull = c.stiffness * c.value + c.damping * moved / h;
    for (std::size_t i = 0; i < entries; ++i) {
      if (isFree(c.lane[i])) residual_[c.lane[i]] += pull * c.gradient[i];
    }
  }

  bool isFree(int lane) const { return inverseMass_[static_cast<std::size_t>(lane)] > 0.0; }

  /// Adds a spring's own matrix k [1 -1; -1 1] on the free lanes of each axis.
  void addDistance(const Constraint& c, double h, int dimension, std::vector<Eigen::Triplet<double>>& entries) const {
    const double k = c.stiffness + c.damping / h;
    for (int axis = 0; axis < dimension; ++axis) {
      const int a = c.lane[static_cast<std::size_t>(axis)];
      if (isFree(a)) entries.emplace_back(a, a, k);
      if (c.count == dimension) continue;  // the other end is no lane
      const int b = c.lane[static_cast<std::size_t>(axis + dimension)];
      if (isFree(b)) entries.emplace_back(b, b, k);
      if (!isFree(a) || !isFree(b)) continue;
      entries.emplace_back(a, b, -k);
      entries.emplace_back(b, a, -k);
    }
  }

  /// Empty, or why there is no matrix.
  std::string refactor(const DynamicalSystem& system, double t, double h, const State& state) {
    const int dimension = system.dimension();
    std::string failure;
    covered_.assign(covered_.size(), false);
    std::vector<Eigen::Triplet<double>> entries;
    // Lanes that are no unknowns have rows of their own, and stay.
    for (int i = 0; i < system.storage(); ++i) {
      entries.emplace_back(i, i, isFree(i) ? mass_[static_cast<std::size_t>(i)] / (h * h) : 1.0);
    }
    const auto add = [&](std::span<const Constraint> constraints) {
      for (const Constraint& c : constraints) {
        if (c.kind != Constraint::Kind::Distance || (c.count != dimension && c.count != 2 * dimension)) {
          failure = fmt::format("{} takes distances only; constraint {} is none", info_.id, c.index);
          continue;
        }
        covered_[static_cast<std::size_t>(c.index)] = true;
        addDistance(c, h, dimension, entries);
      }
    };
    system.constraints()->evaluate(t, state.x, state.z, std::ref(add));
    if (!failure.empty()) return failure;
    matrix_.sparse.resize(system.storage(), system.storage());
    matrix_.sparse.setFromTriplets(entries.begin(), entries.end());
    matrix_.symmetric = true;
    const Factorisation found = solver_.factorise(matrix_, true);
    ++work_.jacobians;
    ++work_.factorisations;
    if (!found.usable) return fmt::format("{}: {}", info_.id, found.failure);
    matrixStep_ = h;
    return {};
  }

  int iterations_;
  double matrixStep_ = 0.0;    // h of the matrix; 0: there is none
  std::vector<bool> covered_;  // constraints that are in the matrix
  SystemMatrix matrix_;
  LinearSolver solver_;
  Vector residual_, increment_, offset_;
};

}  // namespace

std::unique_ptr<Integrator> projectiveDynamics(int iterations) {
  return std::make_unique<ProjectiveDynamics>(iterations);
}

}  // namespace muelle::engine
