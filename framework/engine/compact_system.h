#pragma once
#include "engine/dynamical_system.h"

#include <vector>

namespace muelle::engine {

/// A system as linear algebra sees it: its unknowns alone, in their order, with what is held left out. For methods
/// whose work is the solution of linear equations, beside which the copying does not count.
///
/// Held nodes are where follow() last found them, moved ones where the time says.
class CompactSystem final : public DynamicalSystem, private Potential, private Drag, private Linearisation {
 public:
  /// `system` must outlive this.
  explicit CompactSystem(const DynamicalSystem& system);
  CompactSystem(const CompactSystem&) = delete;
  CompactSystem& operator=(const CompactSystem&) = delete;

  /// Takes over where the held nodes of a state of the whole system are.
  void follow(const State& state);
  /// Overwrites `compact` with the unknowns of a state of the whole system.
  void compact(const State& state, State& compact) const;
  State compact(const State& state) const;
  /// Writes a compact state into one of the whole system, whose held nodes stay; moved ones are placed.
  void expand(const State& compact, State& state) const;
  /// Overwrites an array of unknowns with those of an array of lanes.
  void gather(In lanes, Out unknowns) const;
  /// Writes an array of unknowns into one of lanes, whose other lanes stay.
  void scatter(In unknowns, Out lanes) const;

  int size() const override { return system_.size(); }
  std::span<const double> mass() const override { return mass_; }
  void force(double t, In x, In v, In z, Out f) const override;
  int internalSize() const override { return system_.internalSize(); }
  bool forceUsesVelocity() const override { return system_.forceUsesVelocity(); }
  bool hasUnannouncedForce() const override { return system_.hasUnannouncedForce(); }
  double shortestPeriod(double t) const override { return system_.shortestPeriod(t); }
  const Potential* potential() const override { return system_.potential() != nullptr ? this : nullptr; }
  const Drag* drag() const override { return system_.drag() != nullptr ? this : nullptr; }
  const Linearisation* linearisation() const override { return system_.linearisation() != nullptr ? this : nullptr; }
  std::span<const Rod> rods() const override { return system_.rods(); }
  bool isTied() const override { return system_.isTied(); }
  std::string unknownName(int i) const override { return system_.unknownName(i); }
  int dimension() const override { return system_.dimension(); }

 private:
  /// Room for the whole system's lanes.
  struct Whole {
    std::vector<double> x, v;
  };
  void fill(double t, In x, In v, In z, Whole& whole) const;

  bool isComplete() const override { return system_.potential()->isComplete(); }
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;
  std::span<const double> coefficients() const override { return drag_; }
  void accelerationWithoutDrag(double t, In x, In v, In z, Out a) const override;
  bool remainderUsesVelocity() const override { return system_.drag()->remainderUsesVelocity(); }
  void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form, SystemMatrix& J) const override;

  const DynamicalSystem& system_;
  std::vector<int> lanes_;
  std::vector<double> mass_, drag_;
  mutable Whole first_, second_;
  mutable std::vector<double> result_;
};

}  // namespace muelle::engine
