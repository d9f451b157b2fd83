#pragma once
#include "engine/analysis/test_oscillator.h"
#include "engine/integrator.h"

namespace muelle::engine {

/// What a method's step does to the scalar test equation x'' = -w2 x - (c + d) v (see TestOscillator), measured by
/// letting the method step: the stability function of whatever has been programmed, not of its formula.
class Amplification {
 public:
  /// Runs `method` on systems of its own: prepare() it again before it goes on with another one.
  explicit Amplification(Integrator& method) : method_(method) {}

  /// Spectral radius of a step: the factor by which the state grows a step in the long run. 1 when neither grows nor
  /// decays. The arguments have no dimension: (h omega)^2, h c, h d. A method with memory is run for 200 steps.
  /// Infinite when a step fails; NaN when the method cannot run such an oscillator at all (a Nystroem method with
  /// damping).
  double growth(double stiffness, double damping, double drag = 0.0);

  /// Largest h omega without growth on an undamped oscillator; infinite beyond `most`, 0 when it grows from the
  /// smallest steps on.
  double imaginaryLimit(double most = 1e3);
  /// How far the energy of an undamped oscillator rises above that at its start, at most, whatever its phase: the
  /// factor by which the energy that the method keeps may differ from the true one. Velocity Verlet 1 / (1 - (h
  /// omega)^2 / 4), symplectic Euler (1 + h omega / 2) / (1 - h omega / 2); 1 for a method that grows, which keeps
  /// none. \param z  h omega
  double energySwing(double z);

  /// Largest h c without growth on v' = -c v (a damping that the method takes as any force); as above.
  double realLimit(double most = 1e4);

 private:
  double growthWithMemory();

  Integrator& method_;
  TestOscillator oscillator_;
};

/// Growth a step, less 1, that counts as rounding.
inline constexpr double roundingGrowth = 1e-11;

}  // namespace muelle::engine
