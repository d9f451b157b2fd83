#pragma once
#include "harness/dynamical_system.h"
#include "harness/trajectory.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle {

/// Watches a run for what march() stops at: numbers that are not finite and energy that explodes.
class RunMonitor {
 public:
  /// \param explosion, duration, dimension as in MarchOptions
  RunMonitor(const DynamicalSystem& system, double explosion, double duration, int dimension);
  /// The same with names of the caller's for the unknowns, for systems that number them otherwise, and with the energy
  /// [J] of what is stretched, which then counts as well: near its limit a method may carry little in its velocities.
  RunMonitor(const DynamicalSystem& system, double explosion, double duration,
             std::function<std::string(std::size_t unknown)> name,
             std::function<double(const State&)> potentialEnergy = {});

  /// Checks the first state and its forces, and takes the natural scale of the kinetic energy from them.
  StopReport checkStart(const State& start);
  /// Checks the state after a step from `before`. Allocates nothing while all is well.
  StopReport checkStep(const State& before, const State& after);
  /// The same of a state whose numbers should be finite, for the method looks at them: whether its energy explodes. The
  /// numbers are looked at only when the energy is none.
  StopReport checkEnergy(const State& before, const State& after);

 private:
  StopReport checkFinite(const State& before, const State& after);
  StopReport notFinite(double t, std::size_t unknown, const char* what) const;
  StopReport exploded(const State& state, double energy) const;
  /// Whether the forces at the state are finite; a report when they are not.
  StopReport checkForce(const State& state);

  const DynamicalSystem& system_;
  std::function<double(const State&)> potentialEnergy_;
  double explosion_;
  double duration_;
  std::function<std::string(std::size_t)> name_;
  double energyScale_ = 0.0;
  std::vector<double> force_;
};

}  // namespace muelle
