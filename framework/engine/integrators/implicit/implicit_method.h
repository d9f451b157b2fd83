#pragma once
#include "engine/method.h"
#include "engine/solve/newton.h"

#include <Eigen/Core>

namespace muelle::engine {

/// What the implicit methods share: the facts, Newton's method, its tolerance, and how a failure is told.
class ImplicitMethod : public Method {
 public:
  explicit ImplicitMethod(MethodInfo info);

  const MethodInfo& info() const override { return info_; }
  /// Throws std::invalid_argument when the system lacks a linearisation, or a potential where the method needs one.
  void prepare(const System& system, const Tolerance& tolerance) override;

 protected:
  using Vector = Eigen::VectorXd;

  static Eigen::Map<const Vector> vector(const std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  static Eigen::Map<Vector> vector(std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
  }
  /// Solves stage_ from the guess in w_; the result says which step failed when it did.
  StepResult solveStage(const System& system, const NewtonOptions& options, double h);
  /// Copies z, sets the time and checks that x and v are finite.
  StepResult finish(const State& from, double h, State& to) const;

  MethodInfo info_;
  double tolerance_ = 1e-12;
  Newton newton_;
  ImplicitStage stage_;
  Vector w_;
};

/// A MethodInfo with what all implicit methods have in common.
MethodInfo implicitInfo(std::string id, std::string name, int order, Stability stability);

}  // namespace muelle::engine
