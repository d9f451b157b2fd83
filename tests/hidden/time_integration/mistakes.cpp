/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "time_integration.h"

#include "course/testing/random.h"
#include "course/testing/test_function.h"
#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <fmt/format.h>

namespace {

/// Whether something goes on from the stages, or stays as at the beginning.
enum class Moves { Yes, No };

/// A Runge-Kutta method as students may write it: stage i looks at t + c[i] h, from the beginning on along a[i] times
/// the stages before it, and the step goes along the sum of all, weighted by b.
struct Method {
  std::vector<std::vector<double>> a;
  std::vector<double> c, b;
  Moves askedPosition = Moves::Yes;    ///< what the force is asked with
  Moves askedVelocity = Moves::Yes;    ///< ...
  Moves slopeOfPosition = Moves::Yes;  ///< what the position goes on with at the end: the stages' velocities or v0
  Moves stagePosition = Moves::Yes;    ///< ... and in the stages
};

VecX along(const VecX& from, double h, const std::vector<double>& weights, const std::vector<VecX>& slopes) {
  VecX to = from;
  for (std::size_t i = 0; i < weights.size(); ++i) to += h * weights[i] * slopes[i];
  return to;
}

State step(const Method& method, const Force& force, const VecX& m, const State& now, double h) {
  std::vector<VecX> velocities, accelerations;
  for (std::size_t stage = 0; stage < method.b.size(); ++stage) {
    const std::vector<VecX> old(stage, now.v);
    const bool isFree = method.stagePosition == Moves::Yes;
    const VecX x = along(now.x, h, method.a[stage], isFree ? velocities : old);
    const VecX v = along(now.v, h, method.a[stage], accelerations);
    const VecX F = force(now.t + method.c[stage] * h, method.askedPosition == Moves::Yes ? x : now.x,
                         method.askedVelocity == Moves::Yes ? v : now.v);
    velocities.push_back(method.slopeOfPosition == Moves::Yes ? v : now.v);
    accelerations.emplace_back(F.cwiseQuotient(m));
  }
  return {now.t + h, along(now.x, h, method.b, velocities), along(now.v, h, method.b, accelerations)};
}

VecX accelerationOf(const Force& force, const VecX& m, const State& state) {
  return force(state.t, state.x, state.v).cwiseQuotient(m);
}

const Method euler{{{}}, {0}, {1}};
const Method midpoint{{{}, {0.5}}, {0, 0.5}, {0, 1}};
const Method classical{{{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {0, 0.5, 0.5, 1}, {1 / 6.0, 1 / 3.0, 1 / 3.0, 1 / 6.0}};

Method with(Method method, const std::function<void(Method&)>& change) {
  change(method);
  return method;
}

}  // namespace

// --- what all four may hold -----------------------------------------------------------------------------------------

#define SHARED_MISTAKES(function, ForceType)                                                                           \
  MUELLE_MISTAKE(function, mass_missing, [](const ForceType& force, const VecX& m, const State& now, double h) {       \
    return oracle::function(force, VecX::Ones(m.size()), now, h);                                                      \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, mass_multiplied, [](const ForceType& force, const VecX& m, const State& now, double h) {    \
    return oracle::function(force, m.cwiseInverse(), now, h);                                                          \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, against_the_force, [](const ForceType& force, const VecX& m, const State& now, double h) {  \
    return oracle::function(force, -m, now, h);                                                                        \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, first_mass_for_all, [](const ForceType& force, const VecX& m, const State& now, double h) { \
    return oracle::function(force, VecX::Constant(m.size(), m[0]), now, h);                                            \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, mass_per_node, [](const ForceType& force, const VecX& m, const State& now, double h) {      \
    VecX each = m;                                                                                                     \
    for (Eigen::Index i = 0; i < m.size(); ++i) each[i] = m[i / 3];                                                    \
    return oracle::function(force, each, now, h);                                                                      \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, step_capped, [](const ForceType& force, const VecX& m, const State& now, double h) {        \
    return oracle::function(force, m, now, std::min(h, 1.0));                                                          \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, time_stays, [](const ForceType& force, const VecX& m, const State& now, double h) {         \
    State next = oracle::function(force, m, now, h);                                                                   \
    next.t = now.t;                                                                                                    \
    return next;                                                                                                       \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, position_stays, [](const ForceType& force, const VecX& m, const State& now, double h) {     \
    State next = oracle::function(force, m, now, h);                                                                   \
    next.x = now.x;                                                                                                    \
    return next;                                                                                                       \
  });                                                                                                                  \
  MUELLE_MISTAKE(function, velocity_stays, [](const ForceType& force, const VecX& m, const State& now, double h) {     \
    State next = oracle::function(force, m, now, h);                                                                   \
    next.v = now.v;                                                                                                    \
    return next;                                                                                                       \
  })

SHARED_MISTAKES(explicitEulerStep, Force);
SHARED_MISTAKES(midpointStep, Force);
SHARED_MISTAKES(verletStep, PositionForce);
SHARED_MISTAKES(rungeKuttaStep, Force);

// --- explicit Euler -------------------------------------------------------------------------------------------------

#define FORCE_MISTAKE(function, id, ...) \
  MUELLE_MISTAKE(function, id,           \
                 [](const Force& force, const VecX& m, const State& now, double h) -> State { __VA_ARGS__ })

FORCE_MISTAKE(explicitEulerStep, symplectic_euler, {
  const VecX v = now.v + h * accelerationOf(force, m, now);
  return {now.t + h, now.x + h * v, v};
});
FORCE_MISTAKE(explicitEulerStep, force_at_new_position, {
  const VecX x = now.x + h * now.v;
  return {now.t + h, x, now.v + h * accelerationOf(force, m, {now.t, x, now.v})};
});
FORCE_MISTAKE(explicitEulerStep, parabola, {
  const VecX a = accelerationOf(force, m, now);
  return {now.t + h, now.x + h * now.v + h * h / 2 * a, now.v + h * a};
});
FORCE_MISTAKE(explicitEulerStep, force_at_end_of_time,
              { return step(with(euler, [](Method& method) { method.c = {1}; }), force, m, now, h); });

// --- methods of several stages --------------------------------------------------------------------------------------

/// The step of a method that differs from the right one by `change`.
#define METHOD_MISTAKE(function, id, right, ...) \
  FORCE_MISTAKE(function, id, { return step(with(right, [](Method& method) { __VA_ARGS__; }), force, m, now, h); })

METHOD_MISTAKE(midpointStep, euler_instead, euler, (void)method);
METHOD_MISTAKE(midpointStep, heun, midpoint, method = Method{{{}, {1}}, {0, 1}, {0.5, 0.5}});
METHOD_MISTAKE(midpointStep, time_of_beginning, midpoint, method.c[1] = 0);
METHOD_MISTAKE(midpointStep, time_of_end, midpoint, method.c[1] = 1);
METHOD_MISTAKE(midpointStep, whole_step_to_look, midpoint, method = Method{{{}, {1}}, {0, 1}, {0, 1}});
namespace at_half_the_time {
METHOD_MISTAKE(midpointStep, whole_step_to_look, midpoint, method.a[1] = {1});
}
METHOD_MISTAKE(midpointStep, position_by_old_velocity, midpoint, method.slopeOfPosition = Moves::No);
METHOD_MISTAKE(midpointStep, velocity_of_beginning_asked, midpoint, method.askedVelocity = Moves::No);
METHOD_MISTAKE(midpointStep, position_of_beginning_asked, midpoint, method.askedPosition = Moves::No);
METHOD_MISTAKE(midpointStep, half_a_step, midpoint, method.b[1] = 0.5);
METHOD_MISTAKE(midpointStep, from_the_middle, midpoint, method.b = {0.5, 0.5});
FORCE_MISTAKE(midpointStep, position_by_new_velocity, {
  State next = oracle::midpointStep(force, m, now, h);
  next.x = now.x + h * next.v;
  return next;
});

METHOD_MISTAKE(rungeKuttaStep, equal_weights, classical, method.b = {0.25, 0.25, 0.25, 0.25});
METHOD_MISTAKE(rungeKuttaStep, middle_once, classical, method.b = {1 / 6.0, 1 / 6.0, 1 / 6.0, 1 / 6.0});
METHOD_MISTAKE(rungeKuttaStep, weights_exchanged, classical, method.b = {1 / 3.0, 1 / 6.0, 1 / 6.0, 1 / 3.0});
METHOD_MISTAKE(rungeKuttaStep, k3_from_k1, classical, method.a[2] = {0.5});
namespace of_the_velocity {
FORCE_MISTAKE(rungeKuttaStep, k3_from_k1, {
  const auto a = [&](double ahead, const VecX& x, const VecX& v) -> VecX {
    return accelerationOf(force, m, {now.t + ahead, x, v});
  };
  const VecX v1 = now.v, a1 = a(0, now.x, v1);
  const VecX v2 = now.v + h / 2 * a1, a2 = a(h / 2, now.x + h / 2 * v1, v2);
  const VecX v3 = v2, a3 = a(h / 2, now.x + h / 2 * v2, v3);
  const VecX v4 = now.v + h * a3, a4 = a(h, now.x + h * v3, v4);
  return {now.t + h, now.x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), now.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
});
}
METHOD_MISTAKE(rungeKuttaStep, k4_from_k2, classical, method.a[3] = {0, 1});
METHOD_MISTAKE(rungeKuttaStep, k4_half_a_step, classical, (method.a[3] = {0, 0, 0.5}, method.c[3] = 0.5));
namespace at_the_end {
METHOD_MISTAKE(rungeKuttaStep, k4_half_a_step, classical, method.a[3] = {0, 0, 0.5});
}
METHOD_MISTAKE(rungeKuttaStep, whole_steps_to_look, classical,
               (method.a[1] = {1}, method.a[2] = {0, 1}, method.c = {0, 1, 1, 1}));
namespace at_half_the_time {
METHOD_MISTAKE(rungeKuttaStep, whole_steps_to_look, classical, (method.a[1] = {1}, method.a[2] = {0, 1}));
}
METHOD_MISTAKE(rungeKuttaStep, times_stay, classical, method.c = {0, 0, 0, 0});
METHOD_MISTAKE(rungeKuttaStep, time_of_end_wrong, classical, method.c[3] = 0.5);
METHOD_MISTAKE(rungeKuttaStep, positions_by_old_velocity, classical, method.stagePosition = Moves::No);
METHOD_MISTAKE(rungeKuttaStep, velocity_of_beginning_asked, classical, method.askedVelocity = Moves::No);
METHOD_MISTAKE(rungeKuttaStep, position_by_old_velocity, classical, method.slopeOfPosition = Moves::No);
namespace in_the_sum_alone {
FORCE_MISTAKE(rungeKuttaStep, position_by_old_velocity, {
  State next = oracle::rungeKuttaStep(force, m, now, h);
  next.x = now.x + h * now.v;
  return next;
});
}
METHOD_MISTAKE(rungeKuttaStep, stages_from_the_stage_before, classical,
               (method.a = {{}, {0.5}, {0.5, 0.5}, {0.5, 0.5, 1}}));
METHOD_MISTAKE(rungeKuttaStep, midpoint_instead, midpoint, (void)method);
METHOD_MISTAKE(rungeKuttaStep, euler_instead, euler, (void)method);
METHOD_MISTAKE(rungeKuttaStep, three_eighths, classical,
               (method = Method{{{}, {1 / 3.0}, {-1 / 3.0, 1}, {1, -1, 1}},
                                {0, 1 / 3.0, 2 / 3.0, 1},
                                {1 / 8.0, 3 / 8.0, 3 / 8.0, 1 / 8.0}}));
METHOD_MISTAKE(rungeKuttaStep, sixth_missing, classical, method.b = {1, 2, 2, 1});

// --- velocity Verlet ------------------------------------------------------------------------------------------------

namespace {

/// Where the second force is asked, and how the accelerations enter: x by parabola h^2 a0, v by h (first a0 + second
/// a1).
struct VerletMethod {
  double parabola = 0.5, first = 0.5, second = 0.5;
  double time = 1.0;  ///< of the second question, in parts of h
  bool asksOld = false;
  bool dividesFirst = true, dividesSecond = true;  ///< whether the force is divided by the masses
};

State verlet(const VerletMethod& method, const PositionForce& force, const VecX& m, const State& now, double h) {
  const auto divided = [&m](const VecX& F, bool divides) { return divides ? VecX(F.cwiseQuotient(m)) : F; };
  const VecX a0 = divided(force(now.t, now.x), method.dividesFirst);
  VecX x = now.x + h * now.v, v = now.v;
  const auto add = [h](VecX& to, double weight, const VecX& a) {  // 0 times what has exploded is no number
    if (weight != 0) to += h * weight * a;
  };
  add(x, h * method.parabola, a0);
  add(v, method.first, a0);
  const VecX F1 = force(now.t + method.time * h, method.asksOld ? now.x : x);
  add(v, method.second, divided(F1, method.dividesSecond));
  return {now.t + h, x, v};
}

}  // namespace

#define VERLET_MISTAKE(id, ...)                                                                                       \
  MUELLE_MISTAKE(verletStep, id, [](const PositionForce& force, const VecX& m, const State& now, double h) -> State { \
    return verlet(VerletMethod{__VA_ARGS__}, force, m, now, h);                                                       \
  })

VERLET_MISTAKE(one_acceleration, .first = 1, .second = 0);
VERLET_MISTAKE(new_acceleration_alone, .first = 0, .second = 1);
VERLET_MISTAKE(parabola_missing, .parabola = 0);
VERLET_MISTAKE(parabola_without_half, .parabola = 1);
VERLET_MISTAKE(sum_for_mean, .first = 1, .second = 1);
VERLET_MISTAKE(time_of_beginning, .time = 0);
VERLET_MISTAKE(time_of_middle, .time = 0.5);
VERLET_MISTAKE(old_position_asked, .asksOld = true);
VERLET_MISTAKE(symplectic_euler, .parabola = 1, .first = 1, .second = 0);

/// One of the two forces is divided by the masses, the other is not.
namespace of_one_force {
VERLET_MISTAKE(mass_missing, .dividesSecond = false);
}
namespace of_the_other_force {
VERLET_MISTAKE(mass_missing, .dividesFirst = false);
}
/// What is held stays where it is: nothing accelerates it, and it has no velocity on the way.
MUELLE_MISTAKE(verletStep, three_coordinates,
               [](const PositionForce& force, const VecX& m, const State& now, double h) -> State {
                 const Eigen::Index held = std::max<Eigen::Index>(0, m.size() - 3);
                 VecX heavy = m;
                 State still = now;
                 heavy.tail(held).setConstant(1e300);
                 still.v.tail(held).setZero();
                 State next = oracle::verletStep(force, heavy, still, h);
                 next.v.tail(held) = now.v.tail(held);
                 return next;
               });

// ------------------------------------------------------------------------------------------- arguments in general
// position

namespace {

using muelle::BadQuestion;
using muelle::Random;
using muelle::TestFunction;

/// Forces on two coordinates, of two digits each, so that they can be read.
double someDigits(Random& random, double low, double high) { return std::round(10 * random.number(low, high)) / 10; }

Force someForce(Random& random) {
  const double a = someDigits(random, 1.1, 1.9), k = someDigits(random, 0.6, 1.4), d = someDigits(random, 0.3, 0.8);
  const std::string source = fmt::format(
      "[](double t, const VecX& x, const VecX& v) {{ return VecX({} * std::cos(3 * t) - {} * x.array() - "
      "{} * v.array()); }}",
      a, k, d);
  return TestFunction<VecX(double, const VecX&, const VecX&)>(source, [=](double t, const VecX& x, const VecX& v) {
    if (x.size() != 2 || v.size() != 2) throw BadQuestion("asks for the force on other than two coordinates");
    return VecX(a * std::cos(3 * t) - k * x.array() - d * v.array());
  });
}

PositionForce somePositionForce(Random& random) {
  const double a = someDigits(random, 1.1, 1.9), k = someDigits(random, 0.6, 1.4);
  const std::string source =
      fmt::format("[](double t, const VecX& x) {{ return VecX({} * std::cos(3 * t) - {} * x.array()); }}", a, k);
  return TestFunction<VecX(double, const VecX&)>(source, [=](double t, const VecX& x) {
    if (x.size() != 2) throw BadQuestion("asks for the force on other than two coordinates");
    return VecX(a * std::cos(3 * t) - k * x.array());
  });
}

VecX someMasses(Random& random) { return VecX{{random.rounded(0.6, 0.9), random.rounded(1.2, 1.8)}}; }

State someState(Random& random) {
  const auto some = [&] { return random.rounded(0.3, 1.7); };
  return {some(), VecX{{some(), -some()}}, VecX{{-some(), some()}}};
}

}  // namespace

#define STEP_ARGUMENTS(function, forceOf)         \
  MUELLE_ARGUMENTS(function, [](Random& random) { \
    const auto force = forceOf(random);           \
    const VecX m = someMasses(random);            \
    const State now = someState(random);          \
    const double h = random.rounded(0.2, 0.6);    \
    return std::tuple(force, m, now, h);          \
  })

STEP_ARGUMENTS(explicitEulerStep, someForce);
STEP_ARGUMENTS(midpointStep, someForce);
STEP_ARGUMENTS(verletStep, somePositionForce);
STEP_ARGUMENTS(rungeKuttaStep, someForce);
