#pragma once
#include "engine/method.h"

#include <memory>

namespace muelle::engine {

// The explicit methods, one file each.
std::unique_ptr<Method> explicitEuler();
std::unique_ptr<Method> symplecticEuler();
std::unique_ptr<Method> explicitMidpoint();
std::unique_ptr<Method> velocityVerlet();
std::unique_ptr<Method> rattle();
std::unique_ptr<Method> rungeKutta4();
std::unique_ptr<Method> dormandPrince5();
std::unique_ptr<Method> dop853();
std::unique_ptr<Method> nystrom8();
std::unique_ptr<Method> nystrom12();
std::unique_ptr<Method> yoshida4();
std::unique_ptr<Method> kahanLi8();
std::unique_ptr<Method> rungeKuttaChebyshev2();

}  // namespace muelle::engine
