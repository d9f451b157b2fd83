#pragma once
#include "lab/advise/method_estimate.h"
#include "lab/advise/reference_motion.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace muelle::lab {

/// By so much an error that was found is multiplied before it is printed as "at most about": runs are compared at some
/// times, and between them they may be farther apart.
inline constexpr double statedFactor = 1.25;

/// Below it, in parts of the motion, runs differ by the rounding of their sums, which no reference tells.
inline constexpr double statedLeast = 2e-12;

/// "At most about", from the error that was found and what the reference may be off.
double statedError(double found, double doubt);

/// A run of a method at some setting.
struct TriedPoint {
  double error = 0.0;    ///< in parts of the motion, as it was found
  double seconds = 0.0;  ///< of the processor; of those that were timed side by side without looks
};

/// A method as it came out.
struct Candidate {
  MethodEstimate estimate;
  enum class Fate {
    Unfit,   ///< it cannot run the model
    NotRun,  ///< foreseen to be too slow, or the time was over
    Missed,  ///< run, and no setting of it keeps the tolerance at a time that competes
    Keeps,   ///< keeps the tolerance at `setting`
    Chosen,  ///< and is the cheapest that does
  };
  Fate fate = Fate::NotRun;
  Setting setting;                                         ///< the best that it was run at
  double error = std::numeric_limits<double>::infinity();  ///< "at most about", in parts of the motion
  double seconds = 0.0;    ///< of the processor: measured where it was run, else foreseen
  double orderSeen = 0.0;  ///< from two of its runs; 0: not seen
  int runs = 0;
  std::vector<TriedPoint> points;  ///< of the runs that reached their end
  std::string why;                 ///< one line

  bool keeps() const { return fate == Fate::Keeps || fate == Fate::Chosen; }
};

/// What comes of the search.
struct MethodChoice {
  std::vector<Candidate> candidates;  ///< the chosen one first, then by time, then those that cannot run
  bool outOfTime = false;             ///< candidates were left out because the time was over
  double seconds = 0.0;               ///< of the clock on the wall

  const Candidate* chosen() const;
};

/// Finds for each method, the most promising first, the setting at which it keeps the tolerance at the least cost, as
/// long as it may become the cheapest; then times those that are close side by side.
///
/// \param whole, reference  of the whole model: what was left out of the one that is run counts as error
/// \param seconds  of the clock on the wall
MethodChoice chooseMethod(const Pilots& pilots, const Pilots& whole, const ReferenceMotion& reference,
                          const std::vector<MethodEstimate>& estimates, double tolerance, double seconds,
                          const std::function<void(double)>& progress);

}  // namespace muelle::lab
