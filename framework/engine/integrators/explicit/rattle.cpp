#include "engine/integrators/cubic_interpolant.h"
#include "engine/integrators/explicit/engines/kick.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/methods.h"
#include "engine/solve/linear_solver.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

MethodInfo rattleInfo() {
  MethodInfo info = velocityVerlet()->info();  // which it is without rods
  info.id = "rattle";
  info.name = "RATTLE";
  info.realLimit = 0.0;
  info.needs.velocityFreeForce = true;
  info.holdsRods = true;
  info.formula = "velocity Verlet with forces along the rods: |x+| = L after the drift, d|x|/dt = 0 after each kick";
  info.source =
      "Andersen, J. Comput. Phys. 52 (1983) 24; symplectic: Leimkuhler and Skeel, J. Comput. Phys. 112 (1994) 117";
  info.remark =
      "for rods (springs with rod = true), which no other method holds: lengths to round-off, momenta as velocity "
      "Verlet, energy in a band for ever. The rods set no limit on the step; other springs do, as for velocity "
      "Verlet. Without rods it is velocity Verlet";
  return info;
}

/// The rods at one configuration: directions, and the matrix G M^-1 G^T of their forces on each other, factorised.
struct RodFrame {
  StateMark mark;
  Eigen::SparseMatrix<double> G;  ///< rods x lanes: derivative of the lengths
  SystemMatrix A;
  LinearSolver solver;

  /// Empty, or why it failed.
  std::string set(std::span<const Rod> rods, int dimension, const Vector& inverseMass, In x, Work& work);
};

/// Offset between the ends of a rod, a - b [m].
std::array<double, 3> offset(const Rod& rod, int dimension, In x) {
  std::array<double, 3> d{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
    d[c] = x[static_cast<std::size_t>(rod.a[c])] - x[static_cast<std::size_t>(rod.b[c])];
  }
  return d;
}

std::string RodFrame::set(std::span<const Rod> rods, int dimension, const Vector& inverseMass, In x, Work& work) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < rods.size(); ++j) {
    const auto d = offset(rods[j], dimension, x);
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
      const double n = d[c] / rods[j].length;
      entries.emplace_back(static_cast<int>(j), rods[j].a[c], n);
      entries.emplace_back(static_cast<int>(j), rods[j].b[c], -n);
    }
  }
  G.resize(static_cast<Eigen::Index>(rods.size()), inverseMass.size());
  G.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> transposed = G.transpose();
  A.sparse = G * inverseMass.asDiagonal() * transposed;
  A.sparse.makeCompressed();
  ++work.jacobians;
  ++work.factorisations;
  return solver.factorise(A, true).usable ? "" : "the rods hold each other in more than one way here";
}

/// RATTLE. The force along the rods that the drift needs is found by Newton steps with the matrix at its start, which
/// is off by the turn of a rod in a step; the velocity's follows from one solve.
class Rattle final : public Integrator {
 public:
  const MethodInfo& info() const override {
    static const MethodInfo facts = rattleInfo();
    return facts;
  }

  void prepare(const DynamicalSystem& system, const Tolerance&) override {
    if (system.forceUsesVelocity()) {
      throw std::invalid_argument(
          "rattle needs a force that does not depend on the velocity: remove damping, drag and friction");
    }
    kick_.prepare(system);
    rods_ = system.rods();
    dimension_ = system.dimension();
    const std::span<const double> w = system.inverseMass();
    const auto n = std::ssize(w);
    inverseMass_ = Eigen::Map<const Vector>(w.data(), n);
    dx_.setZero(n);
    dv_.setZero(n);
    residual_.setZero(static_cast<Eigen::Index>(rods_.size()));
    restart();
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    kick_.start(system, from, work_);
    prepareResult(from, h, to);
    const Eigen::Map<const Vector> v0(from.v.data(), dx_.size());
    const auto present = [&] { return Eigen::Map<const Vector>(kick_.acceleration(), dx_.size()); };
    const Eigen::Map<const Vector> a = present();
    dx_ = h * (v0 + (0.5 * h) * a);
    dv_ = (0.5 * h) * a;
    if (std::string failure = drift(from, h, to); !failure.empty()) return failed(h, failure);
    to.v = from.v;
    system.place(to.t, to.z, to.x, to.v);
    kick_.evaluate(system, to.t, to.x, to.v, from.z, work_);
    dv_ += (0.5 * h) * present();  // which is now the end's
    if (std::string failure = stopStretching(from, to); !failure.empty()) return failed(h, failure);
    for (std::size_t i = 0; i < from.v.size(); ++i) to.v[i] = from.v[i] + dv_[static_cast<Eigen::Index>(i)];
    kick_.finish(to);
    end_->mark.set(to);
    return finiteOrFailure(system, from, to, 0.0);
  }

  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override {
    StepResult result = step(system, from, h, increment);
    std::copy(dx_.begin(), dx_.end(), increment.x.begin());
    std::copy(dv_.begin(), dv_.end(), increment.v.begin());
    return result;
  }

  /// The forces along the rods are not known to interpolate with.
  void interpolate(const DynamicalSystem&, const State& from, const State& to, double theta, State& out) override {
    interpolateByVelocities(from, to, theta, out);
  }

  void restart() override {
    kick_.restart();
    start_->mark.clear();
  }
  void accept() override {
    kick_.accept();
    std::swap(start_, end_);
  }

 private:
  static StepResult failed(double h, const std::string& why) {
    return {.done = false, .failure = fmt::format("rattle with h = {:.6g} s: {}", h, why)};
  }

  /// to.x = from.x + dx, with the forces along the rods at the start that make the lengths right at the end; they are
  /// added to dx_ and dv_.
  std::string drift(const State& from, double h, State& to) {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    place(from, to);
    if (rods_.empty()) return "";
    if (!start_->mark.matches(from)) {
      if (std::string failure = start_->set(rods_, dimension_, inverseMass_, from.x, work_); !failure.empty()) {
        return failure;
      }
      start_->mark.set(from);
    }
    const double far = vectorOf(from.x).lpNorm<Eigen::Infinity>();
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i) {
      const double size = stretch(to.x, far);
      if (!(size < 0.5 * last) && last < 1e3 * eps) return "";  // round-off: it falls no further
      if (!std::isfinite(size) || size > 10.0 * last) break;
      if (size == 0.0) return "";
      last = size;
      if (!start_->solver.solve(residual_, force_).empty()) break;
      ++work_.solves;
      push_ = inverseMass_.cwiseProduct(start_->G.transpose() * force_);
      dx_ -= push_;
      dv_ -= push_ / h;
      place(from, to);
    }
    return fmt::format("the rods' lengths are not met, by {:.1e} of them: they turn too far in this step", last);
  }

  /// residual_ = (L^2 - l^2) / (2 l) [m]; the largest over what length and coordinates are rounded to.
  double stretch(In x, double far) {
    double largest = 0.0;
    for (std::size_t j = 0; j < rods_.size(); ++j) {
      const auto d = offset(rods_[j], dimension_, x);
      const double length = rods_[j].length;
      const double r = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - length * length) / (2.0 * length);
      residual_[static_cast<Eigen::Index>(j)] = r;
      const double relative = std::abs(r) / (length + far);
      largest = relative > largest || std::isnan(relative) ? relative : largest;
    }
    return largest;
  }

  /// Takes from dv_ what would stretch the rods at the end.
  std::string stopStretching(const State& from, const State& to) {
    if (rods_.empty()) return "";
    end_->mark.clear();
    if (std::string failure = end_->set(rods_, dimension_, inverseMass_, to.x, work_); !failure.empty()) return failure;
    residual_ = end_->G * (vectorOf(from.v) + dv_);
    if (std::string failure = end_->solver.solve(residual_, force_); !failure.empty()) return failure;
    ++work_.solves;
    dv_ -= inverseMass_.cwiseProduct(end_->G.transpose() * force_);
    return "";
  }

  static Eigen::Map<const Vector> vectorOf(const std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  void place(const State& from, State& to) const {
    for (std::size_t i = 0; i < from.x.size(); ++i) to.x[i] = from.x[i] + dx_[static_cast<Eigen::Index>(i)];
  }

  Kick kick_;
  std::span<const Rod> rods_;
  int dimension_ = 1;
  Vector inverseMass_;
  Vector dx_, dv_;                  ///< change over the step
  Vector residual_, force_, push_;  ///< of the rods, of the rods, of the lanes
  std::unique_ptr<RodFrame> start_ = std::make_unique<RodFrame>(), end_ = std::make_unique<RodFrame>();
};

}  // namespace

std::unique_ptr<Integrator> rattle() { return std::make_unique<Rattle>(); }

}  // namespace muelle::engine
