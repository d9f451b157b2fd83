#include "engine/integrators/explicit/engines/kick.h"

namespace muelle::engine {

void Kick::prepare(const DynamicalSystem& system) {
  drag_ = system.drag();
  usesVelocity_ = drag_ != nullptr ? drag_->remainderUsesVelocity() : system.forceUsesVelocity();
  accelerations_.assign(2, static_cast<std::size_t>(system.storage()));
  restart();
}

void Kick::restart() {
  accepted_ = false;
  end_.clear();
}

void Kick::evaluate(const DynamicalSystem& system, double t, In x, In v, In z, Work& work) {
  accelerations_.swap(0, 1);
  if (drag_ != nullptr) {
    drag_->accelerationWithoutDrag(t, x, v, z, accelerations_[0]);
  } else {
    system.acceleration(t, x, v, z, accelerations_[0]);
  }
  ++work.forceEvaluations;
}

void Kick::start(const DynamicalSystem& system, const State& from, Work& work) {
  const bool kept = accepted_ && end_.matches(from);
  accepted_ = false;
  end_.clear();
  if (!kept) evaluate(system, from.t, from.x, from.v, from.z, work);
}

void Kick::finish(const State& to) { end_.set(to); }

}  // namespace muelle::engine
