#pragma once
#include "lab/advise/reference_motion.h"
#include "lab/advise/simplification.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::lab {

/// What leaving out a part of a model does.
struct PartTrial {
  Simplification part;
  double error = std::numeric_limits<double>::infinity();  ///< "at most about", in parts of the motion
  double timeLeft = 1.0;  ///< time of a run without the part over one with it, at the same setting
  bool measured = false;  ///< whether timeLeft was
  bool leftOut = false;   ///< decided
  std::string why;        ///< one line: the certificate, or what speaks against it
};

/// Leaves out each part on its own, runs the rest as finely as the reference, and compares the two over the whole
/// duration. A part is left out when that changes less than a third of the tolerance and nothing speaks against it:
///
/// An axis, when the forces across it never push away from the plane (no negative eigenvalue of that block of the
/// stiffness at any of the reference's states) and a small disturbance along it hardly grows: so nothing buckles.
/// A contact, when no node comes near: told by the energy, which a scene that nothing drives can only lose, else by the
/// gaps at every step of the reference; then the run that is advised keeps watch itself.
/// Digits, by a run of what is left with the method that is advised, its own error a small part of what is asked for;
/// and only where that saves time. Everything else, by the comparison.
///
/// \param timing   the setting at which both are timed
/// \param seconds  of the clock on the wall
std::vector<PartTrial> tryParts(const Pilots& whole, const ReferenceMotion& reference, const Setting& timing,
                                double tolerance, double seconds);

/// The parts that were decided to be left out. Where together they change more than a third of the tolerance, the one
/// that changes most is kept, and so on.
std::vector<Simplification> leaveOutTogether(const Pilots& whole, const ReferenceMotion& reference,
                                             std::vector<PartTrial>& trials, double tolerance, double seconds);

}  // namespace muelle::lab
