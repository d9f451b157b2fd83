#include "engine/control/mode_keeper.h"

#include <algorithm>

namespace muelle::engine {

ModeKeeper::ModeKeeper(const DynamicalSystem& system, Stepper& stepper, bool locate)
    : switching_(system.switching()), frozen_(locate && switching_ != nullptr) {
  if (!frozen_) return;
  locator_.emplace(system, stepper);
  crossings_.assign(static_cast<std::size_t>(switching_->guardCount()), 0);
}

void ModeKeeper::commitStart(State& state) {
  windowStart_ = state.t;
  if (switching_ != nullptr) switching_->commit(state, frozen_);
}

void ModeKeeper::commitAnew(State& state) {
  windowStart_ = state.t;
  frozen_ = locator_.has_value();
  std::ranges::fill(crossings_, 0);
  if (switching_ == nullptr) return;
  switching_->commit(state, false);  // live, so that the modes are decided by where the state is now
  if (frozen_) switching_->commit(state, true);
}

void ModeKeeper::start(State& state, double nominal) {
  if (locator_) locator_->start(state, nominal);
}

EventLocator::Found ModeKeeper::locate(const State& from, State& to) {
  return frozen_ ? locator_->locate(from, to) : EventLocator::Found{};
}

ModeKeeper::Crossing ModeKeeper::cross(State& state, double nominal) {
  Crossing result;
  if (!frozen_) return result;
  const std::vector<int>& crossed = locator_->crossed();
  for (const int guard : crossed) {
    switching_->cross(guard, state);
    result.events.push_back(switching_->eventName(guard, state));
  }
  if (!chatters(crossed, state.t, nominal)) return result;
  // The force then switches within the next step, as it does without event location.
  frozen_ = false;
  liveUntil_ = state.t + nominal;
  std::ranges::fill(crossings_, 0);
  result.chatter = switching_->guardName(crossed.front());
  return result;
}

/// Whether a guard crosses to and fro so often that the events make no headway.
bool ModeKeeper::chatters(const std::vector<int>& crossed, double t, double nominal) {
  if (t - windowStart_ > nominal) {
    windowStart_ = t;
    std::ranges::fill(crossings_, 0);
  }
  bool often = false;
  for (const int guard : crossed) often |= ++crossings_[static_cast<std::size_t>(guard)] > mostCrossings;
  return often;
}

ModeKeeper::Commit ModeKeeper::commit(State& state, bool jump, double nominal) {
  if (switching_ == nullptr) return {jump, false};
  const bool freezeAgain = locator_ && !frozen_ && state.t >= liveUntil_;
  frozen_ = frozen_ || freezeAgain;
  if (switching_->commit(state, frozen_)) jump = true;
  if (freezeAgain) {
    locator_->start(state, nominal);
  } else if (frozen_) {
    locator_->settle(state);
  }
  return {jump, jump || freezeAgain};
}

}  // namespace muelle::engine
