#pragma once
#include "engine/model/model_system.h"

#include <vector>

namespace muelle::engine {

/// External forces of a model at time t on its lanes [N], gravity not among them.
std::vector<double> externalForces(const ModelSystem& system, double t);

/// A system at one instant: its external forces as dead loads, which have an energy -F . x, so that an equilibrium
/// carries them. All else is the system's, which must outlive this.
class AtRest final : public DynamicalSystem, private Potential {
 public:
  AtRest(const ModelSystem& system, double t);

  int size() const override { return system_.size(); }
  int storage() const override { return system_.storage(); }
  std::span<const int> lanes() const override { return system_.lanes(); }
  std::span<const double> mass() const override { return system_.mass(); }
  std::span<const double> inverseMass() const override { return system_.inverseMass(); }
  void place(double t, In z, Out x, Out v) const override { system_.place(t, z, x, v); }
  void force(double t, In x, In v, In z, Out f) const override { system_.force(t, x, v, z, f); }
  int internalSize() const override { return system_.internalSize(); }
  const Potential* potential() const override { return this; }
  const Linearisation* linearisation() const override { return system_.linearisation(); }
  const Switching* switching() const override { return system_.switching(); }
  std::string unknownName(int i) const override { return system_.unknownName(i); }
  int dimension() const override { return system_.dimension(); }

 private:
  bool isComplete() const override { return false; }
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;

  const ModelSystem& system_;
  std::vector<double> loads_;
};

}  // namespace muelle::engine
