#pragma once
#include "engine/analysis/spectrum.h"
#include "engine/model/model_system.h"

#include <vector>

namespace muelle::lab {

/// In which modes a motion has its energy, from a few states on its way.
struct EnergyShare {
  std::vector<engine::Mode> modes;  ///< with their shares, of sum 1; empty where nothing vibrates
  double fastest = 0.0;             ///< angular frequency of the fastest mode that the system has [1/s]
  /// The pilot number: the share of the energy above a quarter of `fastest`. Where it is small the limit of stability
  /// binds an explicit method's step (velocity Verlet, Takahashi-Imada), else the error does, and high order pays.
  double aboveQuarter = 0.0;
};

/// The kinetic energy of each state is shared out over the modes about it; at rest, the acceleration's.
/// \param touches  whether nodes come to touch an obstacle: then the fastest contact counts as a mode
EnergyShare energyShare(const engine::ModelSystem& system, const std::vector<State>& states, bool touches);

}  // namespace muelle::lab
