#pragma once
#include "engine/method_info.h"

#include <optional>

namespace muelle::hard_cases {

/// A vibration by which a case's error is foreseen: a'' = -stiffness a - (damping + drag) a' + 0, mass 1.
struct Mode {
  double stiffness = 1.0;    ///< omega^2 [1/s^2]; negative on a saddle
  double amplitude = 1.0;    ///< [m] at the start
  double speed = 0.0;        ///< [m/s] at the start
  double damping = 0.0;      ///< by springs and contacts [1/s]
  double drag = 0.0;         ///< by node drag [1/s]
  double sensitivity = 1.0;  ///< the case's error at its end for an error of 1 m in this mode
  double duration = 0.0;     ///< [s]; 0: all of the run
  /// Its end is an event that is located (a contact): an error of phase is then one of time alone, and shifts the rest
  /// of the run; only the amplitude counts with the sensitivity.
  bool located = false;
};

/// What a method at the step h makes of a mode: the numerical end against the exact one. Both from formulas (stability
/// functions, drift and kick matrices), written here and not taken from the methods' code.
struct ModeForecast {
  double error = 0.0;      ///< |numerical - exact| at the end [m], velocities over omega included
  double size = 0.0;       ///< amplitude at the end [m]
  double sizeError = 0.0;  ///< |size - exact size| [m]
  double growth = 1.0;     ///< spectral radius of a step
};

/// Amplitude of the exact solution at the end [m].
double exactSize(const Mode& mode, double duration);

/// Forecast for the methods with a fixed step; empty for those that choose their steps, which have no single matrix.
std::optional<ModeForecast> forecast(const engine::MethodInfo& method, const Mode& mode, double h, double duration);

}  // namespace muelle::hard_cases
