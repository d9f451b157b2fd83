#pragma once
#include <vector>

namespace muelle::hard_cases {

struct Variant;

/// What a case's own motion makes of small errors, computed: the reference motion is run once, and again from states
/// along it that are moved a little.
struct Sensitivity {
  double endSpeed = 0.0;  ///< [m/s] of the fastest node at the end: an error of time is one of place
  /// The change of all velocities by one part in N changes the variant's number by perRelativeSpeed / N: root mean
  /// square over the times at which the velocities carry the motion.
  double perRelativeSpeed = 0.0;
  std::vector<double> times = {};  ///< [s] from which the following were computed
  /// The variant's number at the end for a change of 1 m at a time: any change (root mean square over directions;
  /// velocities are measured in units of the motion's rate), and one along the motion, as an error of phase is.
  std::vector<double> any = {}, along = {};

  /// Root mean square of the growths from the times in [from, to] [s]; from the nearest time when there is none.
  struct Growth {
    double any = 1.0, along = 1.0;
  };
  Growth between(double from, double to) const;
};

/// Diagonal of the box that holds all nodes at all times of a variant's motion [m].
double extentOf(const Variant& variant);

/// The sensitivity of a variant's motion; deterministic. Runs the motion up to about fifty times, on small systems.
Sensitivity sensitivityOf(const Variant& variant);

}  // namespace muelle::hard_cases
