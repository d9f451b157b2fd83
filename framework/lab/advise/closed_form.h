#pragma once
#include "lab/advise/reference_motion.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::lab {

/// A way to the motion without a run of the whole: told, and never written into a file.
struct ClosedForm {
  std::string name;                                        ///< "linear modes", "free flight"
  double error = std::numeric_limits<double>::infinity();  ///< "at most about", in parts of the motion
  bool holds = false;                                      ///< it keeps the tolerance
  std::string why;                                         ///< one line
};

/// What of these a scene could be:
///
/// Linear modes: M y'' = F0 - K y about the start, each mode for itself, q'' = f - s q: q = v0 t sinc(w t) + f (1 - cos
/// w t) / s. Only of scenes that keep their energy, that touch nothing, and of at most 300 unknowns. Its error is found
/// by comparison over the whole duration, so that a resonance of the nonlinear terms, which swings up late, speaks
/// against it.
///
/// Free flight: nodes that nothing but gravity acts on, x0 + v0 t + g t^2 / 2. A touch speaks against it.
std::vector<ClosedForm> closedForms(const Pilots& whole, const ReferenceMotion& reference, double tolerance);

/// Groups of free nodes that no spring, element or property joins with each other, each by its nodes.
std::vector<std::vector<int>> islandsOf(const engine::Model& model);

}  // namespace muelle::lab
