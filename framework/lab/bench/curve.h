#pragma once
#include "lab/bench/contestant.h"
#include "lab/bench/reference.h"
#include "lab/bench/statistics.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::bench {

/// One setting of a contestant.
struct CurvePoint {
  double setting = 0.0;  ///< tolerance, or step [s]
  RunCost cost;
  PathError error;              ///< without meaning where the run failed
  std::vector<double> seconds;  ///< of each timed run, by rounds: element r of all points was measured in turn

  bool failed() const { return !cost.failure.empty(); }
};

/// Everything that one contestant did on a scene, from the coarsest setting to the finest.
struct Curve {
  Row row = Row::Ours;
  std::string library, method;
  bool takesTolerance = false;
  bool locatesEvents = false;
  std::vector<CurvePoint> points;
  std::string ended;  ///< why there are no finer ones: "the next run would take 40 s"
  std::string crash;  ///< an error that is no failed run; empty: none

  std::string label() const { return library + " " + method; }
  std::string key() const { return nameOf(row) + ":" + library + ":" + method; }
  /// Whether a run of it has reached the end of the scene.
  bool hasResult() const;
};

/// Where on a curve an error is met: between two neighbouring points, or at its coarsest.
struct Crossing {
  std::size_t coarse = 0, fine = 0;  ///< indices of points; equal where the coarsest run that stands is better already
  double weight = 0.0;               ///< of the fine point, in logarithms: value = coarse^(1 - weight) fine^weight
};

/// The finest place at which e_x passes `target`: from there on the curve stays below it, so that an error that is
/// small by luck at a coarse setting earns nothing. Failed runs count as errors without bound. Nothing where no run
/// meets the target, or the finest does not.
std::optional<Crossing> crossingAt(const Curve& curve, double target);

/// A quantity at a crossing: coarse^(1 - weight) fine^weight, straight in logarithms as errors and costs are.
double atCrossing(const Crossing& crossing, double coarse, double fine);

/// Seconds at the crossing in round r; of points timed less often the median stands in. Needs a timed run of each.
double secondsAt(const Curve& curve, const Crossing& crossing, std::size_t round);
/// Evaluations at the crossing.
double evaluationsAt(const Curve& curve, const Crossing& crossing);
/// How many rounds both of its points have.
std::size_t roundsAt(const Curve& curve, const Crossing& crossing);

}  // namespace muelle::bench
