#pragma once
#include "engine/integrator.h"

#include <memory>

namespace muelle::engine {

// The implicit methods, one file each.
std::unique_ptr<Integrator> backwardEuler();
std::unique_ptr<Integrator> linearisedBackwardEuler();
std::unique_ptr<Integrator> bdf2();
std::unique_ptr<Integrator> trBdf2();
std::unique_ptr<Integrator> esdirk4();
std::unique_ptr<Integrator> implicitMidpoint();
std::unique_ptr<Integrator> discreteGradient();

}  // namespace muelle::engine
