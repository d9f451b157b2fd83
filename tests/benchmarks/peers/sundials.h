#pragma once
#include "lab/bench/scene.h"
#include "peer_contestant.h"

namespace muelle::bench {

/// SUNDIALS: CVODE's Adams methods (fixed-point iteration), its BDF with the exact Jacobian and KLU; ARKODE's explicit
/// methods of order 4 and 8, and its ESDIRK of order 4 with the exact Jacobian and KLU.
template <class Problem>
void addSundials(const Problem& problem, Contestants& all);

/// CVODE's Adams methods with root finding on a ball over a ground, each phase integrated as a smooth one. Row A.
/// `scene` must outlive it.
void addCvodeBall(const BenchScene& scene, Contestants& all);

std::string sundialsVersion();

}  // namespace muelle::bench
