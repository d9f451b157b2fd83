#pragma once
#include "engine/model/model_system.h"
#include "engine/scene/scene.h"
#include "lab/advise/path_rows.h"
#include "lab/advise/setting.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::lab {

/// The equal times at which runs of a scene are compared, the end the last of them.
///
/// A scene with an output interval is looked at through dense output, as `muelle run` records it, at some of its
/// outputs; another one at ends of steps: fixed steps fall on these times, of others the first end behind each time
/// counts.
class Looks {
 public:
  explicit Looks(const engine::Scene& scene);

  std::size_t count() const { return times_.size(); }
  double time(std::size_t i) const { return times_[i]; }
  bool isDense() const { return dense_; }
  /// How many equal steps of about `h` [s], no longer, fill the duration so that some of them end at these times.
  long long stepsOf(double h) const;
  /// Which of the times are looked at in a run with so many fixed steps.
  std::vector<std::size_t> ofSteps(long long steps) const;
  /// `most` of the times or fewer, evenly spread.
  std::vector<std::size_t> some(std::size_t most) const;

 private:
  double duration_;
  bool dense_;
  std::vector<double> times_;
};

/// Until when a run may go on.
struct PilotLimits {
  double seconds = std::numeric_limits<double>::infinity();  ///< of the clock on the wall
  double ofProcessor =
      std::numeric_limits<double>::infinity();  ///< [s]: waiting on a busy machine is no fault of a run
  bool isReference = false;      ///< looked at at all times, at ends of steps; motion, states and gaps are kept
  bool watchesGaps = false;      ///< gaps are kept
  bool looksOften = false;       ///< at every end of a step or every output of the scene, a thousand of them
  const State* start = nullptr;  ///< in place of the scene's
};

/// What became of a run.
struct PilotRun {
  Setting setting;  ///< the step as it was taken
  PathRows rows;
  double seconds = 0.0;  ///< of the processor
  long long steps = 0, evaluations = 0;
  std::string failure;             ///< one line; empty when the end was reached
  bool outOfTime = false;          ///< it was given up
  double reached = 0.0;            ///< [s] of the scene
  MotionSize motion;               ///< of a reference
  std::vector<State> states;       ///< of a reference: the start and some on the way
  std::vector<double> leastGap;    ///< [m] of a node from each obstacle, at any end of a step
  std::vector<double> sureGap;     ///< less the way of a node in a step: that much is left between the ends, too
  std::vector<double> startGap;    ///< [m] of each obstacle
  std::vector<double> firstTouch;  ///< [s] of each obstacle; infinite: never
  bool done() const { return failure.empty(); }
  bool touches() const;
};

/// Runs of one model of a scene. The scene, the system and the obstacles must outlive it.
class Pilots {
 public:
  /// \param watched  obstacles that nodes are seen to keep away from; null: the model's own
  Pilots(const engine::Scene& scene, const engine::ModelSystem& system,
         const std::vector<engine::Obstacle>* watched = nullptr)
      : scene_(scene),
        system_(system),
        looks_(scene),
        watched_(watched != nullptr ? *watched : system.model().obstacles) {}

  const engine::ModelSystem& system() const { return system_; }
  const engine::Scene& scene() const { return scene_; }
  const Looks& looks() const { return looks_; }

  /// Runs the scene to its end. A step is made a little shorter, so that steps end where runs are compared.
  PilotRun run(const Setting& setting, const PilotLimits& limits) const;
  /// The state at t [s], not before `from`, by steps from there as this setting takes them.
  State advance(const Setting& setting, const State& from, double t) const;
  /// Seconds of the processor of a run as the scene asks for it: nothing is compared, its outputs are made. Runs that
  /// are shorter than a millisecond are repeated.
  double bareSeconds(const Setting& setting) const;
  /// Seconds of a step of h [s] from the start, by a few of them.
  double secondsOfStep(const std::string& method, double h) const;

 private:
  engine::StepOptions optionsOf(const Setting& setting) const;
  std::vector<double> outputTimes() const;
  void runBare(const Setting& setting) const;
  void follow(const engine::StepOptions& options, const std::vector<double>& looks, const PilotLimits& limits,
              PilotRun& run) const;

  const engine::Scene& scene_;
  const engine::ModelSystem& system_;
  Looks looks_;
  const std::vector<engine::Obstacle>& watched_;
};

/// Why the method cannot run the system, one line; empty when it can.
std::string refusalOf(const engine::ModelSystem& system, const std::string& method);

}  // namespace muelle::lab
