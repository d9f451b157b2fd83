#include "lab/advise/energy_share.h"

#include <algorithm>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double ofContact = 0.1;  // a guess: how much of the energy goes through contacts

}  // namespace

EnergyShare energyShare(const ModelSystem& system, const std::vector<State>& states, bool touches) {
  EnergyShare share;
  double total = 0.0;
  for (const State& at : states) {
    const LinearisedSystem linearised(system, at);
    const CompactSystem& compact = linearised.system();
    const State state = compact.compact(at);
    for (const Mode& mode : extremeModes(linearised)) share.fastest = std::max(share.fastest, mode.frequency());
    std::vector<double> y = state.v;
    const bool rests = std::ranges::all_of(y, [](double v) { return v == 0.0; });
    if (rests) {
      compact.force(state.t, state.x, state.v, state.z, y);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] /= compact.mass()[i];
    }
    const double weight = rests ? 1.0 : system.kineticEnergy(at);
    // A start at rest says which modes the load moves, not how much: it counts only where nothing else does.
    if (rests && total > 0.0) continue;
    for (Mode mode : modesOf(linearised, y)) {
      mode.energy *= weight;
      total += mode.energy;
      share.modes.push_back(mode);
    }
    if (rests) {
      for (Mode& mode : share.modes) mode.energy *= 1e-9 / std::max(total, 1e-300);
      total = 1e-9;
    }
  }
  if (touches) {
    // While nodes touch the contact vibrates, and steps have to follow it.
    State closed = states.front();
    system.switching()->close(closed);
    Mode contact;
    for (const Mode& mode : extremeModes(LinearisedSystem(system, closed))) {
      if (mode.frequency() > contact.frequency()) contact = mode;
    }
    share.fastest = std::max(share.fastest, contact.frequency());
    contact.energy = total > 0.0 ? ofContact * total : 1.0;
    total += contact.energy;
    share.modes.push_back(contact);
  }
  for (Mode& mode : share.modes) {
    mode.energy /= total;
    if (mode.frequency() > 0.25 * share.fastest) share.aboveQuarter += mode.energy;
  }
  return share;
}

}  // namespace muelle::lab
