#pragma once
#include "engine/integrator.h"

#include <memory>

namespace muelle::engine {

// The position based methods, one file each. A step of h is divided into substeps (xpbd) or iterations (projective
// dynamics); their numbers are arguments because they decide the error.
std::unique_ptr<Integrator> xpbd(int substeps = 20);
std::unique_ptr<Integrator> projectiveDynamics(int iterations = 10);

}  // namespace muelle::engine
