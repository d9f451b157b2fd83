#pragma once

namespace muelle::engine {

/// What a run has cost, in units that do not depend on the machine.
struct Work {
  long long steps = 0;             ///< accepted steps
  long long inClosedForm = 0;      ///< of these steps, for no force
  long long rejectedSteps = 0;     ///< steps that were taken again with a smaller h
  long long forceEvaluations = 0;  ///< of the whole system, line searches included
  long long jacobians = 0;         ///< matrices assembled
  long long factorisations = 0;
  long long solves = 0;  ///< with a factorisation
  long long newtonIterations = 0;
  long long events = 0;  ///< located events and declared times

  Work& operator+=(const Work& other);
};

}  // namespace muelle::engine
