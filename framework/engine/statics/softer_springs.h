#pragma once
#include "engine/statics/equilibrium.h"
#include "engine/statics/tension_form.h"

#include <memory>

namespace muelle::engine {

/// What came of a search with softer springs.
struct SofterSearch {
  std::unique_ptr<TensionForm> form;  ///< a balanced shape of the system's own springs; null: none was found
  bool ranAway = false;               ///< with softer springs some node went beyond StaticOptions::furthest ...
  State furthest;                     ///< ... to here
  Work work;
};

/// Downhill by positions from `start` with springs no stiffer than so that the loads strain them by a thousandth or so,
/// then Newton's method on tensions with the system's own stiffness from the shape there, at once or by tens: by
/// positions alone stiff springs make the way a gorge. Nothing is searched where no spring is stiffer than that, or
/// there is no load. The system must outlive the result.
SofterSearch balanceBySofterSprings(const ModelSystem& system, const State& start, const StaticOptions& options);

}  // namespace muelle::engine
