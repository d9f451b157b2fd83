#pragma once
#include "engine/compact_system.h"
#include "engine/integrator.h"
#include "engine/solve/newton.h"

#include <Eigen/Core>
#include <optional>

namespace muelle::engine {

/// What the implicit methods share: the facts, Newton's method, its tolerance, and how a failure is told.
class ImplicitMethod : public Integrator {
 public:
  explicit ImplicitMethod(MethodInfo info);

  const MethodInfo& info() const override { return info_; }
  /// Throws std::invalid_argument when the system lacks a linearisation, or a potential where the method needs one.
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) final;
  bool hasIncrements() const final { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) final;
  /// To order 2 by positions and velocities alone. Where a step is many periods of a stiff spring long, h^2 a is its
  /// force's last bit of stretch times (h omega)^2, and would throw nodes about between the steps.
  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override;

 protected:
  using Vector = Eigen::VectorXd;

  static Eigen::Map<const Vector> vector(const std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  static Eigen::Map<Vector> vector(std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  /// Computes the change over a step into dx_ and dv_. The system and the state are compact: unknowns alone.
  virtual StepResult advance(const DynamicalSystem& system, const State& from, double h) = 0;
  /// Solves stage_ from the guess in w_; the result says which step failed when it did.
  StepResult solveStage(const DynamicalSystem& system, const NewtonOptions& options, double h);
  /// Makes stage_ the one of the midpoint for the increment w of velocity over the whole step:
  /// M w = h F(tm, x0 + h (v0 + w/2) / 2, v0 + w/2).
  void setMidpointStage(const State& from, double h);
  /// Whether a step starts where the last one ended, up to the last bits, which compensated summation may change.
  static bool follows(const State& from, const State& end, double h);

  MethodInfo info_;
  double tolerance_ = 1e-12;
  Newton newton_;
  ImplicitStage stage_;
  Vector w_;        ///< solution of the stage: an increment of velocity
  Vector dx_, dv_;  ///< change over the step

 private:
  StepResult advanceWhole(const DynamicalSystem& system, const State& from, double h, State& to);

  std::optional<CompactSystem> compact_;
  State from_;  ///< of compact_
};

/// A MethodInfo with what all implicit methods have in common.
MethodInfo implicitInfo(std::string id, std::string name, int order, Stability stability);

}  // namespace muelle::engine
