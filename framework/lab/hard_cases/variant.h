#pragma once
#include "lab/hard_cases/linear_theory.h"
#include "lab/hard_cases/models.h"
#include "lab/hard_cases/running.h"
#include "lab/hard_cases/sensitivity.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace muelle::hard_cases {

/// The step of each kind of method, and the tolerance of those that choose theirs.
struct Steps {
  double first = 1e-3;      ///< [s] explicit methods of order 1 and 2, and the position based ones
  double fourth = 1e-3;     ///< [s] explicit, order 4
  double eighth = 1e-2;     ///< [s] explicit, order 8
  double implicit = 1e-3;   ///< [s]; iterative methods go with the explicit ones of order 1, or by `iterative`
  double tolerance = 1e-8;  ///< in parts of the motion
  double iterative = 0.0;   ///< [s]; 0: as first

  double of(const engine::MethodInfo& method) const;
  /// The tolerance of an adaptive method. That of one of order 2 is its power 2/3: its steps go with the root of what
  /// it is asked for, which at 1e-14 would be ten million of them; so they go with the third root of `tolerance`.
  double toleranceOf(const engine::MethodInfo& method) const;
};

/// Which number a cell is judged by.
enum class Measure {
  Error,         ///< distance from the reference [m]
  Energy,        ///< relative change of an invariant that is quadratic in the motion (energy, angular momentum)
  AngularSpeed,  ///< relative change of the angular momentum
  Size,          ///< what is left of the motion [m]: it should be gone
  Amplitude,  ///< factor between the amplitude and the exact one, the larger over the smaller: a motion that has been
              ///< killed is infinitely far off
};

/// A case as it is run in the matrix: what, for how long, at which steps, and what counts as passed; and the facts from
/// which the outcome is predicted.
struct Variant {
  std::string id = {};        ///< "H04"
  std::string name = {};      ///< "regular": when a case has several variants
  std::string measured = {};  ///< "distance from the reference at t = 10 s [m]"
  Model model = {};
  double duration = 1.0;  ///< [s]
  double bar = 1e-3;      ///< largest error that passes
  Steps steps = {};
  std::function<double(const Finished&)> error = {};
  Measure measure = Measure::Error;

  // Facts for the prediction.
  std::vector<Mode> modes = {};
  bool linear = false;     ///< linear theory is exact; elsewhere its forecasts are trusted to a factor of 3
  bool sensitive = false;  ///< the motion makes more or less of an error on its way to the end: `sensitivity` is needed
  std::optional<Sensitivity> sensitivity = {};  ///< computed (completeFacts())
  double extent = 0.0;  ///< [m] of a motion that is not linear: nothing bounded is further off; computed likewise
  double flightAcceleration =
      0.0;                    ///< [m/s^2] of a ballistic part of the motion, by which first order methods are off ...
  double flightTime = 0.0;    ///< ... after this time [s]
  double stiffest = 0.0;      ///< [1/s] omega of the stiffest mode of a non-linear scene with large motions
  int coupled = 1;            ///< constraints that act on each other: an iteration does not solve them at once
  double stretch = 0.0;       ///< [m] of the coupled constraints under their load; 0: as the largest amplitude
  bool realTime = false;      ///< its bar is asked for in no more time than the motion takes
  bool inClosedForm = false;  ///< events apart, each component goes its own way (DynamicalSystem::laneMotion)
  bool inputs = false;        ///< not a run: steps and states that must be refused (H24)

  std::string label() const { return name.empty() ? id : id + " " + name; }
};

/// The larger of a ratio of amplitudes and its inverse, at most 1e6: that is as good as gone, or as good as infinite.
double amplitudeFactor(double ratio);

/// Computes what of a variant's facts is computed by runs of its own motion, where it is missing.
void completeFacts(Variant& variant);

/// All variants, in the order of the cases.
std::vector<Variant> allVariants();

}  // namespace muelle::hard_cases
