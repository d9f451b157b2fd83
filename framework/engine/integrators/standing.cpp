#include "engine/integrators/standing.h"

namespace muelle::engine {

namespace {

using Because = Standing::Because;

constexpr Standing standing[] = {
    {"explicit_euler", Because::Exercise, "time_integration"},
    {"symplectic_euler", Because::Figure, "order_of_convergence"},
    {"explicit_midpoint", Because::Exercise, "time_integration"},
    {"velocity_verlet", Because::Exercise, "time_integration"},
    {"takahashi_imada", Because::Alone, "undamped scenes that stability binds, a sixtieth of velocity Verlet's error"},
    {"rattle", Because::Alone, "rods, whose length it keeps"},
    {"runge_kutta_4", Because::Exercise, "time_integration"},
    {"dormand_prince_5", Because::Figure, "tolerance_against_error"},
    {"dop853", Because::Figure, "tolerance_against_error"},
    {"rkn64", Because::Plane, "ball"},
    {"nystrom8", Because::Figure, "tolerance_against_error"},
    {"nystrom12", Because::Figure, "tolerance_against_error"},
    {"yoshida4", Because::Figure, "long_time"},
    {"kahan_li_8", Because::Figure, "long_time"},
    {"rkc2", Because::Figure, "tolerance_against_error"},
    {"linearised_backward_euler", Because::Exercise, "stiffness"},
    {"backward_euler", Because::Figure, "numerical_damping"},
    {"bdf2", Because::Figure, "numerical_damping"},
    {"tr_bdf2", Because::Alone, "stiff scenes at frame rate, within a tolerance"},
    {"esdirk4", Because::Alone, "stiff scenes that are to be exact"},
    {"implicit_midpoint", Because::Figure, "long_time"},
    {"discrete_gradient", Because::Figure, "energy_drift"},
    {"xpbd", Because::Alone, "what games do with constraints, to be compared with"},
    {"projective_dynamics", Because::Alone, "what games do with springs, to be compared with"},
};

constexpr GoneMethod gone[] = {
    {"newmark", "implicit_midpoint",
     "The same stability function and the same work, and no more exact: the scene damping_dominated_cloth in steps of "
     "1 ms has an error of 0.0019 in 4.3 s by Newmark's average acceleration and of 0.0019 in 4.4 s by the implicit "
     "midpoint rule, which keeps the angular momentum and is symplectic besides"},
};

}  // namespace

std::span<const Standing> standings() { return standing; }
std::span<const GoneMethod> goneMethods() { return gone; }

}  // namespace muelle::engine
