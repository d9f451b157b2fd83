#pragma once
#include "engine/dynamical_system.h"

namespace muelle::engine {

/// The scalar test equation of the methods, x'' = -stiffness x - (damping + drag) v with mass 1, offered with every
/// capability that a method may need. Damping is a force between things (a spring's), drag the kind that a method may
/// integrate exactly.
class TestOscillator : public DynamicalSystem, public Potential, public Drag, public Linearisation, public Constraints {
 public:
  double stiffness = 1.0;  ///< [1/s^2]; negative on a saddle
  double damping = 0.0;    ///< [1/s]
  double drag1 = 0.0;      ///< [1/s]; see drag()

  int size() const override { return 1; }
  std::span<const double> mass() const override { return {&one_, 1}; }
  void force(double t, In x, In v, In z, Out f) const override;
  bool forceUsesVelocity() const override { return damping != 0.0 || drag1 != 0.0; }
  const Potential* potential() const override { return this; }
  const Drag* drag() const override { return drag1 != 0.0 ? this : nullptr; }
  const Linearisation* linearisation() const override { return this; }
  const Constraints* constraints() const override { return this; }

  bool isComplete() const override { return !forceUsesVelocity(); }
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;
  std::span<const double> coefficients() const override { return {&drag1, 1}; }
  void accelerationWithoutDrag(double t, In x, In v, In z, Out a) const override;
  bool remainderUsesVelocity() const override { return damping != 0.0; }
  void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form, SystemMatrix& J) const override;
  int count() const override { return 1; }
  void evaluate(double t, In x, In z, const ConstraintBlocks::Take& take) const override;
  void project(double t, In z, const ConstraintProjection& projection) const override;
  void externalForce(double t, In x, In v, In z, Out f) const override;
  std::string leftOut() const override { return {}; }

 private:
  Constraint constraintAt(double x) const;

  double one_ = 1.0;
};

}  // namespace muelle::engine
