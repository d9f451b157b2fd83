#pragma once
#include "lab/advise/energy_share.h"
#include "lab/advise/pilot.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::lab {

/// What is known of a method on a model before it is run to the end.
struct MethodEstimate {
  Setting setting;  ///< where a search begins: the step or the tolerance that the estimate has for the error
  int order = 1;
  std::string refusal;                                           ///< why it cannot be a candidate; empty when it can
  double largestStep = std::numeric_limits<double>::infinity();  ///< [s], of a fixed step: stability, periods that act
  double stepForError = 0.0;                                     ///< [s], by linear theory
  double secondsOfStep = 0.0;                                    ///< measured on the spot
  double seconds = std::numeric_limits<double>::infinity();      ///< foreseen, of the whole run
  double leastSeconds = 0.0;  ///< at the largest step that it may take; of a fixed step

  bool fits() const { return refusal.empty(); }
};

/// Unit costs of a model, measured on the spot [s].
struct UnitCosts {
  double evaluation = 0.0;     ///< of the force
  double factorisation = 0.0;  ///< with assembling the matrix and one solve: a step of linearised backward Euler; 0:
                               ///< not measured
};
UnitCosts unitCosts(const Pilots& pilots);

/// Every method of the catalogue on the model, those that fit first, by the time that is foreseen.
std::vector<MethodEstimate> estimateMethods(const Pilots& pilots, const EnergyShare& share, const UnitCosts& costs,
                                            double tolerance);

}  // namespace muelle::lab
