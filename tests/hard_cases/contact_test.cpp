/// \file
/// H17 to H22: forces that switch: contact, friction, pulses.

#include "engine/integrators/catalogue.h"
#include "engine/integrators/position_based/methods.h"
#include "engine/statics/equilibrium.h"
#include "lab/hard_cases/models.h"
#include "lab/hard_cases/references.h"
#include "lab/hard_cases/running.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::hard_cases {
namespace {

// ---------------------------------------------------------------------------------------------------------------- H17

double ballError(const Finished& end) { return std::abs(end.x(0)[0] - reference("H17", "z(10)")); }

TEST(H17BounceOnPenaltyPlane, ElevenBouncesInTenSeconds) {
  const Finished end = run(bouncingBall(), "velocity_verlet", fixedStep(1e-4, 10.0));
  ASSERT_FALSE(end.result.failed()) << end.result.trajectory.stop.message;
  EXPECT_LT(ballError(end), 1e-4);
  EXPECT_NEAR(end.v(0)[0], reference("H17", "v(10)"), 1e-3);
  EXPECT_EQ(end.result.events.size(), 2 * static_cast<std::size_t>(reference("H17", "n_bounces(10)")));
  EXPECT_NEAR(end.energy(), reference("H17", "E"), 1e-4);
}

TEST(H17BounceOnPenaltyPlane, AdaptiveMethodsWithLocatedContact) {
  for (const char* id : {"dormand_prince_5", "dop853"}) {
    const Finished end = run(bouncingBall(), id, withTolerance(1e-9, 10.0));
    EXPECT_LT(ballError(end), 3e-6) << id;
    EXPECT_LT(end.result.work.forceEvaluations, 7705) << id;
  }
}

TEST(H17BounceOnPenaltyPlane, ApexContactTimeAndDepth) {
  engine::RunOptions options = withTolerance(1e-10, 10.0);
  options.keepStates = true;
  options.outputInterval = 1e-3;
  const Finished end = run(bouncingBall(), "dormand_prince_5", options);
  double apex = 0.0, depth = 0.0;
  for (std::size_t n = 0; n < end.result.trajectory.t.size(); ++n) {
    if (end.result.trajectory.t[n] > 9.0) apex = std::max(apex, end.result.trajectory.x[n][0]);
    depth = std::max(depth, -end.result.trajectory.x[n][0]);
  }
  EXPECT_NEAR(apex, 1.0, 1e-3);
  EXPECT_LE(depth, reference("H17", "max_penetration") * (1.0 + 1e-6));
  EXPECT_GE(depth, reference("H17", "max_penetration") * 0.99);
  ASSERT_EQ(end.result.events.size(), 22U);
  for (std::size_t i = 0; i < 22; i += 2) {
    const double contact = end.result.events[i + 1].t - end.result.events[i].t;
    EXPECT_LT(relative(contact, reference("H17", "t_contact")), 1e-3);
  }
  EXPECT_NEAR(end.result.events[2].t - end.result.events[0].t, reference("H17", "period"), 1e-6);
}

TEST(H17BounceOnPenaltyPlane, ContactWithoutGravityLastsHalfAPeriod) {
  const Finished end = run(bouncingBallWithoutGravity(), "runge_kutta_4", fixedStep(1e-3, 2.0));
  ASSERT_EQ(end.result.events.size(), 2U);
  const double contact = end.result.events[1].t - end.result.events[0].t;
  EXPECT_LT(relative(contact, reference("H17", "zero_g.t_contact")), 1e-3);
  EXPECT_NEAR(end.v(0)[0], 1.0, 1e-3);
}

TEST(H17BounceOnPenaltyPlane, LaunchedAtFrameRateWithoutEvents) {
  for (const char* id : {"symplectic_euler", "velocity_verlet", "runge_kutta_4"}) {
    EXPECT_GT(ballError(run(bouncingBall(), id, blindStep(1.0 / 60, 10.0))), 100.0) << id;
  }
  for (const char* id : {"velocity_verlet", "runge_kutta_4"}) {
    EXPECT_GT(ballError(run(bouncingBall(), id, blindStep(1.0 / 240, 10.0))), 0.3) << id;
  }
}

// ---------------------------------------------------------------------------------------------------------------- H18

TEST(H18RestAndStack, EquilibriaCarryTheirLoads) {
  const struct {
    Model model;
    int top;
    const char* name;
  } cases[] = {{restingBall(20.0), 0, "single.penetration"},
               {stack(1e4, 1.0, 12.0), 9, "stack.z10"},
               {stack(1e6, 1000.0, 12.0), 9, "heavy.z10"}};
  for (const auto& [model, top, name] : cases) {
    // From closed contacts: with open gaps nothing holds the stack, and a node may step over the one below it.
    const Finished closed = run(model, "backward_euler", fixedStep(0.01, 0.3));
    const engine::ModelSystem* system = closed.system.get();
    const engine::StaticResult rest = engine::equilibrium(*system, closed.result.last);
    ASSERT_TRUE(rest.converged) << name << ": " << rest.message;
    const double expected = top == 0 ? -reference("H18", name) : reference("H18", name);
    EXPECT_NEAR(system->position(rest.state, top)[0], expected, 1e-9) << name;
  }
}

void expectRest(const Finished& end, int top, double height, const char* what) {
  ASSERT_FALSE(end.result.failed()) << what << ": " << end.result.trajectory.stop.message;
  EXPECT_NEAR(end.x(top)[0], height, 1e-6) << what;
  EXPECT_LE(end.system->kineticEnergy(end.result.last), 1e-12) << what;
}

TEST(H18RestAndStack, DampedMotionComesToRest) {
  for (const char* id : {"velocity_verlet", "backward_euler", "implicit_midpoint"}) {
    expectRest(run(restingBall(20.0), id, fixedStep(1e-3, 10.0)), 0, -reference("H18", "single.penetration"), id);
    expectRest(run(stack(1e4, 1.0, 12.0), id, fixedStep(2e-3, 10.0)), 9, reference("H18", "stack.z10"), id);
    expectRest(run(stack(1e6, 1000.0, 12.0), id, fixedStep(5e-4, 10.0)), 9, reference("H18", "heavy.z10"), id);
  }
}

TEST(H18RestAndStack, FewProjectionsLetTheHeavyTopSink) {
  const auto few = engine::xpbd(1);
  const Finished end = run(stack(1e6, 1000.0, 12.0), *few, fixedStep(1.0 / 60, 10.0));
  EXPECT_LT(end.x(9)[0], reference("H18", "heavy.z10") - 0.05);
}

TEST(H18RestAndStack, ExplicitStepBeyondTheLimitOfTheGroundJitters) {
  // omega = 100 /s: the limit is 0.02 s. Beyond it the ball never rests.
  const Finished end = run(restingBall(2.0), "symplectic_euler", blindStep(0.025, 10.0));
  EXPECT_GT(end.system->kineticEnergy(end.result.last) + std::abs(end.x(0)[0]), 1e-3);
}

// ---------------------------------------------------------------------------------------------------------------- H19

TEST(H19Tunnelling, NothingPassesWithAnyMethodAtAnyStep) {
  for (const std::string& id : engine::methodIds()) {
    if (engine::methodInfo(id).needs.distanceConstraints) continue;  // a contact is none
    for (const double h : {1.0 / 60, 2e-4}) {
      engine::RunOptions options = engine::methodInfo(id).adaptive ? withTolerance(1e-6, 0.1) : fixedStep(h, 0.1);
      const Finished end = run(tunnelling(), id, options);
      // A method that damps like backward Euler may leave the node on the face that it hit.
      EXPECT_LT(end.x(0)[0], 1e-12) << id << " h=" << h;
    }
  }
}

TEST(H19Tunnelling, ReboundsWithItsSpeed) {
  // The contact lasts (h omega)^2 / 24 of its 1.57e-4 s longer or shorter, h omega = 0.02: 2.6e-9 s of 100 m/s are
  // 2.6e-7 m. Its speed comes back as the energy does: rounding of 1e-16 a step in 1e5 steps, and events located to
  // 1e-13 s under 2e6 m/s^2. Of a step of 1e-5 s the swept bound leaves a tenth in the slab.
  for (const auto& [id, h] : {std::pair("velocity_verlet", 1e-6), std::pair("runge_kutta_4", 1e-5)}) {
    const Finished end = run(tunnelling(), id, fixedStep(h, 0.1));
    EXPECT_NEAR(end.x(0)[0], reference("H19", "x(0.1)"), 3e-7) << id;
    EXPECT_NEAR(end.v(0)[0], reference("H19", "v(0.1)"), 1e-5) << id;
  }
  // A tolerance is a part of the motion, here of 10 m and 200 m/s.
  const Finished end = run(tunnelling(), "dormand_prince_5", withTolerance(1e-11, 0.1));
  EXPECT_NEAR(end.x(0)[0], reference("H19", "x(0.1)"), 1e-9);
  EXPECT_NEAR(end.v(0)[0], reference("H19", "v(0.1)"), 1e-8);
  EXPECT_GT(end.result.subdividedSteps + static_cast<long long>(end.result.events.size()), 0);
}

TEST(H19Tunnelling, BareStepsPassThrough) {
  const auto system = engine::build(tunnelling());
  for (const char* id : {"symplectic_euler", "velocity_verlet"}) {
    const auto method = engine::makeMethod(id);
    const State end = bareSteps(*system, *method, system->initialState(), 1.0 / 60, 6);
    EXPECT_NEAR(system->position(end, 0)[0], 9.0, 1e-9) << id;
  }
}

// ---------------------------------------------------------------------------------------------------------------- H20

double slidDistance(const Finished& end, double degrees) {
  const Vec3 start = end.system->position(end.system->initialState(), 0);
  return downhill(end.x(0), start, degrees);
}

TEST(H20FrictionIncline, SticksBelowTheThreshold) {
  for (const char* id : {"velocity_verlet", "dormand_prince_5", "backward_euler"}) {
    engine::RunOptions options =
        std::string(id) == "dormand_prince_5" ? withTolerance(1e-6, 10.0) : fixedStep(2e-4, 10.0);
    options.keepStates = true;
    options.outputInterval = 1.0;
    const Finished end = run(incline(26.5, 0.0), id, options);
    ASSERT_FALSE(end.result.failed()) << id << ": " << end.result.trajectory.stop.message;
    // It starts balanced: nothing creeps, and what an adaptive method's tolerance moves comes back.
    const auto& x = end.result.trajectory.x;
    ASSERT_GE(x.size(), 11U);
    const double creep = std::hypot(x.back()[0] - x[1][0], x.back()[1] - x[1][1]);
    EXPECT_LE(creep, 1e-9) << id;
    EXPECT_LE(std::abs(slidDistance(end, 26.5)), 1e-9) << id;
  }
}

TEST(H20FrictionIncline, SlidesAboveTheThreshold) {
  for (const double degrees : {26.6, 30.0}) {
    const std::string name = degrees > 29.0 ? "(30)" : "(26.6)";
    const Finished end = run(incline(degrees, 0.0), "velocity_verlet", fixedStep(1e-4, 10.0));
    ASSERT_FALSE(end.result.failed()) << end.result.trajectory.stop.message;
    // A constant acceleration, which Verlet takes exactly: the rounding of 50,000 steps.
    EXPECT_LT(relative(slidDistance(end, degrees), reference("H20", "slide" + name)), 1e-12);
    EXPECT_LT(relative(end.v(0).norm(), 10.0 * reference("H20", "acceleration" + name)), 1e-11);
    // A method of order 1 is off by h a t / 2: h / t of the whole.
    const Finished first = run(incline(degrees, 0.0), "backward_euler", fixedStep(2e-4, 10.0));
    EXPECT_NEAR(slidDistance(first, degrees) / reference("H20", "slide" + name) - 1.0, 2e-5, 1e-7);
  }
}

// Between sticking and sliding by bisection, over 1 s each: 1e-4 degrees above it a = 1.9e-5 m/s^2 slides 1e-5 m.
TEST(H20FrictionIncline, ThresholdIsTheArcTangentOfMu) {
  double sticks = 26.5, slides = 26.6;
  while (slides - sticks > 1e-4) {
    const double middle = 0.5 * (sticks + slides);
    const Finished end = run(incline(middle, 0.0), "velocity_verlet", fixedStep(1e-4, 1.0));
    (slidDistance(end, middle) > 1e-7 ? slides : sticks) = middle;
  }
  EXPECT_NEAR(slides, reference("H20", "threshold_degrees"), 2e-4);
  EXPECT_LE(sticks, reference("H20", "threshold_degrees") + 1e-6);
}

TEST(H20FrictionIncline, StopsOnTheFlatWithoutReversal) {
  engine::RunOptions options = fixedStep(1e-4, 2.0);
  options.keepStates = true;
  const Finished end = run(incline(0.0, 3.0), "velocity_verlet", options);
  ASSERT_FALSE(end.result.failed()) << end.result.trajectory.stop.message;
  // Where it stops, within a step, is an event: the distance is exact but for the rounding of 6,000 steps.
  EXPECT_LT(relative(slidDistance(end, 0.0), reference("H20", "flat.distance")), 1e-12);
  double furthest = 0.0;
  for (const auto& x : end.result.trajectory.x) furthest = std::max(furthest, x[0]);
  EXPECT_LE(furthest - end.x(0)[0], 1e-12) << "no reversal";
  EXPECT_LT(end.v(0).norm(), 1e-9);
}

// ---------------------------------------------------------------------------------------------------------------- H21

TEST(H21OverdampedContact, SticksAndCreeps) {
  const double z2 = reference("H21", "z(2)");
  const Finished adaptive = run(overdampedContact(), "dormand_prince_5", withTolerance(1e-9, 2.0));
  EXPECT_NEAR(adaptive.x(0)[0], z2, 1e-6);
  const Finished verlet = run(overdampedContact(), "runge_kutta_4", fixedStep(1e-4, 2.0));
  EXPECT_NEAR(verlet.x(0)[0], z2, 1e-6);
}

TEST(H21OverdampedContact, NeverLeavesTheGroundAgain) {
  engine::RunOptions options = fixedStep(1.0 / 60, 2.0);
  options.keepStates = true;
  for (const char* id : {"backward_euler", "bdf2"}) {
    const Finished end = run(overdampedContact(), id, options);
    EXPECT_NEAR(end.x(0)[0], reference("H21", "z(2)"), 1e-4) << id;
    for (std::size_t n = 0; n < end.result.trajectory.t.size(); ++n) {
      if (end.result.trajectory.t[n] > 0.5) {
        EXPECT_LE(end.result.trajectory.x[n][0], 0.0) << id << " t=" << end.result.trajectory.t[n];
      }
    }
  }
}

TEST(H21OverdampedContact, ExplicitMethodsAreFiredAtFrameRate) {
  for (const char* id : {"explicit_euler", "symplectic_euler", "runge_kutta_4"}) {
    EXPECT_GT(std::abs(run(overdampedContact(), id, blindStep(1.0 / 60, 2.0)).x(0)[0]), 100.0) << id;
  }
  EXPECT_GT(std::abs(run(overdampedContact(), "symplectic_euler", blindStep(1e-3, 2.0)).x(0)[0]), 10.0);
}

// ---------------------------------------------------------------------------------------------------------------- H22

TEST(H22Pulse, DeclaredTimesMakeItExact) {
  for (const char* id : {"velocity_verlet", "runge_kutta_4", "kahan_li_8", "implicit_midpoint"}) {
    const Finished end = run(pulse(), id, fixedStep(1.0 / 60, 2.0));
    EXPECT_NEAR(end.x(0)[0], reference("H22", "x(2)"), 1e-12) << id;
    EXPECT_NEAR(end.v(0)[0], reference("H22", "v(2)"), 1e-12) << id;
  }
  for (const char* id : {"dormand_prince_5", "dop853"}) {
    for (const double tolerance : {1e-3, 1e-12}) {
      const Finished end = run(pulse(), id, withTolerance(tolerance, 2.0));
      EXPECT_NEAR(end.x(0)[0], reference("H22", "x(2)"), 1e-12) << id;
      EXPECT_GE(end.result.work.events, 2) << id;
    }
  }
}

TEST(H22Pulse, WithoutDeclaredTimesItIsRefusedWithoutALargestStep) {
  Model undeclared = pulse();
  undeclared.externalForces[0].times.clear();
  undeclared.externalForces[0].mayJump = true;
  undeclared.externalForces[0].force = [](double t, int) -> Vec3 {
    return t >= 1.0 && t < 1.001 ? Vec3(1000, 0, 0) : Vec3::Zero();
  };
  EXPECT_THROW(run(undeclared, "dormand_prince_5", withTolerance(1e-6, 2.0)), std::invalid_argument);
  engine::RunOptions capped = withTolerance(1e-6, 2.0);
  capped.largestStep = 2e-4;
  EXPECT_NEAR(run(undeclared, "dormand_prince_5", capped).x(0)[0], reference("H22", "x(2)"), 1e-3);
}

TEST(H22Pulse, FixedStepsThatDoNotSeeItAreWrong) {
  EXPECT_GT(std::abs(run(pulse(), "velocity_verlet", blindStep(1.0 / 60, 2.0)).x(0)[0] - 0.9995), 0.5);
}

}  // namespace
}  // namespace muelle::hard_cases
