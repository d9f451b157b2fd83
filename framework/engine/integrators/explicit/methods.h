#pragma once
#include "engine/integrator.h"

#include <memory>

namespace muelle::engine {

// The explicit methods, one file each.
std::unique_ptr<Integrator> explicitEuler();
std::unique_ptr<Integrator> symplecticEuler();
std::unique_ptr<Integrator> explicitMidpoint();
std::unique_ptr<Integrator> velocityVerlet();
std::unique_ptr<Integrator> takahashiImada();
std::unique_ptr<Integrator> rattle();
std::unique_ptr<Integrator> rungeKutta4();
std::unique_ptr<Integrator> dormandPrince5();
std::unique_ptr<Integrator> dop853();
std::unique_ptr<Integrator> rkn64();
std::unique_ptr<Integrator> nystrom8();
std::unique_ptr<Integrator> nystrom12();
std::unique_ptr<Integrator> yoshida4();
std::unique_ptr<Integrator> kahanLi8();
std::unique_ptr<Integrator> rungeKuttaChebyshev2();

}  // namespace muelle::engine
