#pragma once
#include "engine/method.h"

#include <memory>

namespace muelle::engine {

// The implicit methods, one file each.
std::unique_ptr<Method> backwardEuler();
std::unique_ptr<Method> linearisedBackwardEuler();
std::unique_ptr<Method> bdf2();
std::unique_ptr<Method> trBdf2();
std::unique_ptr<Method> esdirk4();
std::unique_ptr<Method> newmark();
std::unique_ptr<Method> implicitMidpoint();
std::unique_ptr<Method> discreteGradient();

}  // namespace muelle::engine
