#pragma once
#include "engine/control/event_locator.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::engine {

/// Keeps the modes of a system that switches while steps are taken: frozen within a step where events are located, and
/// live for a while where a guard crosses to and fro so often that the events make no headway.
class ModeKeeper {
 public:
  /// \param locate  whether events are located; without it modes are always live
  ModeKeeper(const DynamicalSystem& system, Stepper& stepper, bool locate);

  bool frozen() const { return frozen_; }
  /// Commits a first state, or one that was changed from outside: its modes are then decided anew, its anchors stay.
  void commitStart(State& state);
  void commitAnew(State& state);
  /// Before the first step of `nominal` [s] from this state: on which side of each guard it lies.
  void start(State& state, double nominal);

  /// Looks for the first event in the step just taken, see EventLocator::locate().
  EventLocator::Found locate(const State& from, State& to);

  struct Crossing {
    std::vector<std::string> events;  ///< in the user's words
    std::string chatter;              ///< name of the guard whose events are left out from here on; empty: none
  };
  /// Sets the modes of what has been crossed at the step's end.
  Crossing cross(State& state, double nominal);

  struct Commit {
    bool jump = false;     ///< the force may have changed
    bool restart = false;  ///< the method has to forget what it knows of earlier steps
  };
  /// Commits an accepted state. \param jump  something has jumped there already
  Commit commit(State& state, bool jump, double nominal);

  /// A guard that crosses more often than this within a step chatters.
  static constexpr int mostCrossings = 20;

 private:
  bool chatters(const std::vector<int>& crossed, double t, double nominal);

  const Switching* switching_;
  bool frozen_;
  std::optional<EventLocator> locator_;
  std::vector<int> crossings_;  // of each guard since windowStart_
  double windowStart_ = 0.0;
  double liveUntil_ = 0.0;  // after chatter: events are not located before this time
};

}  // namespace muelle::engine
