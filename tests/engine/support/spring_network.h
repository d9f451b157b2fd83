#pragma once
#include "engine/dynamical_system.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace muelle::engine::testing {

/// Springs between free nodes and fixed points, with gravity, node drag and projected damping: written from the
/// formulas of the lecture with dense blocks and no regard for speed, apart from the engine's own forces.
class SpringNetwork : public DynamicalSystem, public Potential, public Linearisation, public Constraints {
 public:
  struct Spring {
    int a = 0;
    int b = -1;            ///< -1: the fixed point `anchor`
    double k = 1.0;        ///< [N/m]
    double L0 = 1.0;       ///< [m]
    double damping = 0.0;  ///< projected [kg/s]
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  };

  /// `mass` per node; `gravity` has as many entries as the dimension.
  SpringNetwork(int dimension, const std::vector<double>& mass, std::vector<Spring> springs, Eigen::VectorXd gravity,
                double drag = 0.0);

  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  void force(double t, In x, In v, In z, Out f) const override;
  const Potential* potential() const override { return this; }
  const Linearisation* linearisation() const override { return this; }
  const Constraints* constraints() const override { return this; }
  int dimension() const override { return dimension_; }

  bool isComplete() const override { return complete_; }
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;
  void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form, SystemMatrix& J) const override;

  int count() const override { return static_cast<int>(springs_.size()); }
  void evaluate(double t, In x, In z, const ConstraintBlocks::Take& take) const override;
  void project(double t, In z, const ConstraintProjection& projection) const override;
  void externalForce(double t, In x, In v, In z, Out f) const override;
  std::string leftOut() const override { return notCovered; }

  /// What leftOut() answers: for a test of the message.
  std::string notCovered;
  /// Total energy, kinetic and potential [J].
  double totalEnergy(const State& state) const;

 private:
  Eigen::VectorXd offset(const Spring& s, In x) const;
  Eigen::VectorXd relativeVelocity(const Spring& s, In v) const;
  Constraint constraintOf(const Spring& s, In x) const;
  void add(const Spring& s, const Eigen::VectorXd& onA, Out f) const;
  void addGravity(Out f) const;

  int dimension_;
  std::vector<double> mass_;
  std::vector<Spring> springs_;
  Eigen::VectorXd gravity_;
  double drag_;
  bool complete_;
};

}  // namespace muelle::engine::testing
