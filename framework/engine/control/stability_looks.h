#pragma once
#include "engine/analysis/look_budget.h"
#include "engine/control/simulate.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// What can be said of a fixed step: that it is too long for the stiffest mode, or for a bounce, or that the method
/// damps what the scene does not. All looks of a run together cost 5 % of its foreseen force evaluations or 200,
/// whichever is larger (LookBudget).
class StabilityLooks {
 public:
  StabilityLooks(const DynamicalSystem& system, const MethodInfo& method, const RunOptions& options);

  /// Whether anything is to be looked at: not with steps that follow the error estimate.
  bool wanted() const { return wanted_; }
  /// A line for each thing that is wrong, before the run. The method is run on other systems for it.
  std::vector<std::string> before(Integrator& method, const State& start);
  /// The same after modes have switched on that the look before may not have counted (several contacts at once); empty
  /// when all is well, has been said, or has been looked at three times.
  std::string afterSwitch(const State& state);

 private:
  std::string bounce(const State& start) const;

  const DynamicalSystem& system_;
  const MethodInfo& method_;
  const RunOptions& options_;
  bool wanted_;
  LookBudget budget_;
  int looks_ = 0;
  bool warnedOfInstability_ = false;
};

}  // namespace muelle::engine
