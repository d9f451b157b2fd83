#pragma once
#include "lab/bench/curve.h"
#include "lab/bench/record.h"
#include "lab/bench/reference.h"
#include "lab/bench/stopwatch.h"

#include <functional>
#include <vector>

namespace muelle::bench {

/// The errors at which speeds are compared.
inline constexpr double targets[] = {1e-2, 1e-4, 1e-6, 1e-8};

/// The methods of the engine that the lecture's figure shows, on the pendulum: all their points are timed in the
/// rounds.
inline constexpr const char* lectureScene = "pendulum";
inline constexpr const char* lectureMethods[] = {"velocity_verlet",   "runge_kutta_4", "dormand_prince_5",
                                                 "implicit_midpoint", "kahan_li_8",    "nystrom12"};

/// How long a sweep may take, and how fine it is.
struct SweepOptions {
  double longestRun = 5.0;       ///< [s] no run is begun that is foreseen to take longer
  double leastTimed = 2e-3;      ///< [s] a shorter run is repeated until so much time has passed
  double hopeless = 10.0;        ///< so many times slower than another of its row at no larger error, twice: it ends
  int rounds = 15;               ///< interleaved runs of what competes for an entry of the table
  double secondsOfRounds = 600;  ///< [s] fewer rounds, down to five, where they would take longer
  double toleranceFactor = 0.31622776601683794;  ///< from one tolerance to the next
  double stepFactor = 0.70710678118654752;       ///< from one step to the next
  double closeness = 1.6;                        ///< who comes so near to the best of a row competes in the rounds
  Clock now = processorTime;
  std::function<void(double fraction)> progress = [](double) {};
};

/// What a sweep has found on a scene.
struct SceneResult {
  std::string name, title;
  SceneKind kind = SceneKind::Small;
  int unknowns = 0, springs = 0;
  double duration = 0.0;     ///< [s] simulated
  PathError doubt = {};      ///< of the reference
  std::string arbiter = {};  ///< the peer's run that it was held against
  double amplification = 0.0;
  std::vector<Curve> curves = {};
  std::vector<std::string> left = {};  ///< methods that cannot run the scene, with the reason
  int rounds = 0;
  double busy = 0.0;  ///< processes that wanted a processor besides ours, on average (load less one)

  /// Whether the reference is good enough for an error: a hundred times better.
  bool allows(double target) const { return 100.0 * doubt.position <= target; }
  const Curve* find(const std::string& key) const;
};

/// Runs all contestants from coarse to fine, each setting once with its error, then those that compete for an entry of
/// the table in interleaved rounds. What the record has is not run again.
SceneResult sweep(const BenchScene& scene, const Contestants& contestants, const Reference& reference, Record& record,
                  const SweepOptions& options);

/// Judges the reference by the best run of the peers that take a tolerance, on their own force.
void judge(Reference& reference, const BenchScene& scene, const Contestants& contestants, Record& record);

}  // namespace muelle::bench
