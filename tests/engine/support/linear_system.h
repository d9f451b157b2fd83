#pragma once
#include "engine/dynamical_system.h"

#include <Eigen/Core>

namespace muelle::engine::testing {

/// M a = -K x - D v with dense symmetric K and D, with every capability that follows from them: the test equation of
/// the methods, and the simplest system there is.
class LinearSystem : public DynamicalSystem, public Potential, public Linearisation, public Drag {
 public:
  LinearSystem(Eigen::VectorXd mass, Eigen::MatrixXd K, Eigen::MatrixXd D);
  /// One unknown of mass 1: a = -omega^2 x - damping v.
  LinearSystem(double omega, double damping);

  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return {mass_.data(), static_cast<std::size_t>(mass_.size())}; }
  void force(double t, In x, In v, In z, Out f) const override;
  bool forceUsesVelocity() const override { return !undamped_; }
  const Potential* potential() const override { return this; }
  const Linearisation* linearisation() const override { return this; }
  /// Only when D is diagonal.
  const Drag* drag() const override { return diagonalDamping_ ? this : nullptr; }

  bool isComplete() const override { return undamped_; }
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;
  void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form, SystemMatrix& J) const override;
  std::span<const double> coefficients() const override {
    return {drag_.data(), static_cast<std::size_t>(drag_.size())};
  }
  void accelerationWithoutDrag(double t, In x, In v, In z, Out a) const override;
  bool remainderUsesVelocity() const override { return !diagonalDamping_; }

 private:
  Eigen::VectorXd mass_;
  Eigen::MatrixXd K_, D_;
  Eigen::VectorXd drag_;
  bool undamped_;
  bool diagonalDamping_;
};

}  // namespace muelle::engine::testing
