#pragma once
#include "engine/method_info.h"

#include <limits>
#include <optional>

namespace muelle::hard_cases {

/// A vibration by which a case's error is foreseen: a'' = -stiffness a - (damping + drag) a' + 0, mass 1.
struct Mode {
  double stiffness = 1.0;    ///< omega^2 [1/s^2]; negative on a saddle
  double amplitude = 1.0;    ///< [m] at the start
  double speed = 0.0;        ///< [m/s] at the start
  double damping = 0.0;      ///< by springs and contacts [1/s]
  double drag = 0.0;         ///< by node drag [1/s]
  double sensitivity = 1.0;  ///< the part of the mode in the case's number: of its judged node, or a scale
  double duration = 0.0;     ///< [s]; 0: all of the run
  int leastSteps = 0;        ///< in its duration, where an obstacle's swept bound cuts steps
  /// A contact: its end is located and carries the velocity on, so that an error of phase is one of time alone, and
  /// only an error of the speed is one of the motion after it.
  bool located = false;
  /// A contact whose damper would pull once a step overshoots: it opens there, and the ringing is over.
  bool cannotPull = false;
  /// Friction at rest, whose forces are balanced anew with each step: a method with memory starts afresh every time.
  bool startsAfresh = false;
};

/// What a method makes of a mode: the numerical end against the exact one.
struct ModeForecast {
  double error = 0.0;        ///< |numerical - exact| at the end [m], velocities over omega included
  double position = 0.0;     ///< numerical - exact, position alone [m]
  double size = 0.0;         ///< amplitude at the end [m]
  double exactSize = 0.0;    ///< of the exact solution [m]
  double amplitude = 0.0;    ///< relative error of the amplitude, in the long run (without what comes and goes)
  double phase = 0.0;        ///< error of the phase [rad], likewise; 0 where nothing oscillates
  double growth = 1.0;       ///< spectral radius of a step; 1 where a run was measured
  double steps = 0.0;        ///< steps taken
  double evaluations = 0.0;  ///< force evaluations of a measured run
};

/// Amplitude of the exact solution at the end [m].
double exactSize(const Mode& mode, double duration);

/// Forecast for a method with a fixed step by its formula (stability function, drift and kick matrices), written here
/// and not taken from the method's code; empty for methods of which no formula is written here, or that choose their
/// steps.
std::optional<ModeForecast> forecast(const engine::MethodInfo& method, const Mode& mode, double h, double duration);

/// How a method is let loose on a mode.
struct ModeRun {
  double duration = 1.0;   ///< [s]
  double h = 0.0;          ///< [s] of a fixed step; 0: the method chooses its steps by the tolerance
  double tolerance = 0.0;  ///< relative and absolute
  double largestStep = std::numeric_limits<double>::infinity();  ///< [s]
  long long budget = 0;                                          ///< most force evaluations
};

/// Forecast for any other method: it is run on the mode alone (engine::TestOscillator), never on the case. Empty when
/// it cannot run there; growth is infinite when the run ended early.
std::optional<ModeForecast> measuredForecast(const engine::MethodInfo& method, const Mode& mode, const ModeRun& run);

}  // namespace muelle::hard_cases
