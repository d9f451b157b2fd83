#pragma once
#include "lab/advise/pilot.h"

#include <string>
#include <vector>

namespace muelle::lab {

/// A motion of a model that is exact as far as an adviser has to tell: two runs, of two methods where the model has
/// two such, the second with the finer tolerance, that agree far better than the error that is asked for.
struct ReferenceMotion {
  PilotRun run;            ///< the finer of the two
  double doubt = 0.0;      ///< what they differ by, in parts of the motion
  std::string how;         ///< "nystrom8 at tolerance 1e-09, beside dop853 at tolerance 2e-08"
  std::string failure;     ///< why there is none, one line; empty when there is
  bool outOfTime = false;  ///< there is none because the time was over
  bool disagrees = false;  ///< there is none because runs do not agree, however fine
  double seconds = 0.0;    ///< of the processor, of all runs that it took

  bool stands() const { return failure.empty(); }
  /// The error of a run of any model of the scene. \param whole  of the model that this is a reference of
  double errorOf(const Pilots& whole, const PathRows& rows) const;
};

/// \param tolerance  the error that is asked for: the runs have to agree to a fiftieth of it, or as well as rounding
///                   lets them where that is an eighth
/// \param seconds    of the clock on the wall that it may take
ReferenceMotion findReference(const Pilots& pilots, double tolerance, double seconds);

/// By how much a disturbance of the start, at most 1e-7 of the motion at every free node, has grown at its largest;
/// infinite where the disturbed run did not reach its end.
/// \param axis  of the disturbance: 0, 1, 2; -1: in all directions
/// \param seconds  of the clock on the wall that it may take
double growthOf(const Pilots& pilots, const ReferenceMotion& reference, int axis, double seconds);

}  // namespace muelle::lab
