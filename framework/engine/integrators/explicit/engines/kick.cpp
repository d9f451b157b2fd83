#include "engine/integrators/explicit/engines/kick.h"

#include <algorithm>

namespace muelle::engine {

void Kick::prepare(const DynamicalSystem& system) {
  drag_ = system.drag();
  usesVelocity_ = drag_ != nullptr ? drag_->remainderUsesVelocity() : system.forceUsesVelocity();
  const std::span<const double> mass = system.mass();
  inverseMass_.resize(mass.size());
  std::transform(mass.begin(), mass.end(), inverseMass_.begin(), [](double m) { return 1.0 / m; });
  acceleration_.assign(mass.size(), 0.0);
  restart();
}

void Kick::restart() {
  accepted_ = false;
  end_.clear();
}

void Kick::evaluate(const DynamicalSystem& system, double t, In x, In v, In z, Work& work) {
  if (drag_ != nullptr) {
    drag_->forceWithoutDrag(t, x, v, z, acceleration_);
  } else {
    system.force(t, x, v, z, acceleration_);
  }
  ++work.forceEvaluations;
  for (std::size_t i = 0; i < acceleration_.size(); ++i) acceleration_[i] *= inverseMass_[i];
}

void Kick::start(const DynamicalSystem& system, const State& from, Work& work) {
  const bool kept = accepted_ && end_.matches(from);
  accepted_ = false;
  end_.clear();
  if (!kept) evaluate(system, from.t, from.x, from.v, from.z, work);
}

void Kick::finish(const State& to) {
  // A force at a predicted velocity is not that of the end state: it is not kept.
  if (!usesVelocity_) end_.set(to);
}

}  // namespace muelle::engine
