#pragma once
#include "engine/scene/scene.h"

#include <string>

namespace muelle::lab {

/// How a scene is run: by a method with a fixed step, or with a tolerance that chooses its steps.
struct Setting {
  std::string method;  ///< id of the catalogue
  bool fixed = true;   ///< `value` is a step [s]; else a tolerance of a method with an error estimate
  double value = 0.0;

  /// "velocity_verlet", or "nystrom8, fixed step" of a method that could choose its steps.
  std::string name() const;
  /// "h = 0.002 s", "tolerance 1e-06".
  std::string valueText() const;
};

/// The scene with this method, step or tolerance in place of its own.
engine::Scene withSetting(engine::Scene scene, const Setting& setting);

}  // namespace muelle::lab
