/// \file
/// A node that slides over an incline and is pushed across it: its path turns, and friction with it. The reference is
/// Coulomb's law integrated on its own by Fehlberg's method of Boost.odeint, in the plane of the incline.

#include "engine/control/motion_frame.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/run/error_estimate.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace muelle::lab {

namespace sliding {

using namespace engine;
namespace {

constexpr double g = 9.81, mu = 0.3, k = 1e4, across = 2.0, duration = 1.0;
const double angle = 20.0 * std::numbers::pi / 180.0;

/// 1 kg in the incline as deep as it is carried there, pushed across at 2 m/s.
Model incline(double roughness = mu, double push = across) {
  Model model;
  model.gravity = Vec3(0.0, 0.0, -g);
  Obstacle plane;
  plane.normal = Vec3(std::sin(angle), 0.0, std::cos(angle));
  plane.material = {.k = k, .mu = roughness};
  model.obstacles.push_back(plane);
  model.nodes.push_back({.x = -g * std::cos(angle) / k * plane.normal, .v = Vec3(0.0, push, 0.0)});
  return model;
}

/// (down, across, their speeds) at `time`: dv/dt = g sin(angle) down - mu g cos(angle) v / |v|.
std::array<double, 4> byCoulomb(double roughness = mu, double push = across, double time = duration) {
  namespace odeint = boost::numeric::odeint;
  using Numbers = std::array<double, 4>;
  Numbers y = {0.0, 0.0, 0.0, push};
  const auto slope = [roughness](const Numbers& at, Numbers& rate, double) {
    const double speed = std::hypot(at[2], at[3]), friction = roughness * g * std::cos(angle);
    rate = {at[2], at[3], g * std::sin(angle) - friction * at[2] / speed, -friction * at[3] / speed};
  };
  odeint::integrate_adaptive(odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<Numbers>()), slope, y,
                             0.0, time, 1e-3);
  return y;
}

/// Without events every run takes friction between steps as it was before them: finer runs share that mistake.
TEST(SlidingFriction, HasNoEstimateWithoutEvents) {
  Scene scene;
  scene.model = incline();
  scene.method = "velocity_verlet";
  scene.step = 1e-3;
  scene.duration = duration;
  EXPECT_EQ(estimateError(scene, runScene(scene)).failure, "");
  scene.locateEvents = false;
  EXPECT_EQ(estimateError(scene, runScene(scene)).failure, "friction sticks and slips between steps (events are off)");
}

TEST(SlidingFriction, IsInsideTheErrorControl) {
  const std::array<double, 4> exact = byCoulomb();
  const Vec3 down(std::cos(angle), 0.0, -std::sin(angle));
  const std::unique_ptr<ModelSystem> system = build(incline());
  const State start = system->initialState();
  const Vec3 origin = system->position(start, 0);
  const double size = std::hypot(exact[0], exact[1]);
  for (const char* id : {"dop853", "dormand_prince_5", "esdirk4", "tr_bdf2", "rkc2"}) {
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
      RunOptions options;
      options.duration = duration;
      options.tolerance.relative = tolerance;
      const std::unique_ptr<Integrator> method = makeMethod(id);
      const RunResult result = simulate(*system, *method, start, options);
      ASSERT_FALSE(result.failed()) << result.trajectory.stop.message;
      const Vec3 way = system->position(result.last, 0) - origin;
      const double off = std::hypot(way.dot(down) - exact[0], way[1] - exact[1]);
      EXPECT_LE(off, 10.0 * tolerance * size) << id << " at " << tolerance;
    }
  }
}

/// With mu above tan(angle) the node comes to rest, its path turning downhill the faster the slower it is: where a step
/// meets the halt, implicit methods have to find a solution, too. At rest when f |v| + s v_down, which falls by f^2 -
/// s^2 a second, is 0 (f friction's deceleration, s the slope's acceleration).
TEST(SlidingFriction, ComesToRestWithEveryMethod) {
  const double rough = 0.6, push = 0.8, f = rough * g * std::cos(angle), s = g * std::sin(angle);
  const double halt = f * push / (f * f - s * s);
  // A millionth of the time before it; what is left is a millionth of a millionth of the way.
  const std::array<double, 4> exact = byCoulomb(rough, push, halt * (1.0 - 1e-6));
  const double size = std::hypot(exact[0], exact[1]);
  const Vec3 down(std::cos(angle), 0.0, -std::sin(angle));
  const std::unique_ptr<ModelSystem> system = build(incline(rough, push));
  const State start = system->initialState();
  const Vec3 origin = system->position(start, 0);
  const auto off = [&](const char* id, const RunOptions& options) {
    const std::unique_ptr<Integrator> method = makeMethod(id);
    const RunResult result = simulate(*system, *method, start, options);
    EXPECT_FALSE(result.failed()) << id << ": " << result.trajectory.stop.message;
    // Held by the slider's spring, of the ground's stiffness, it keeps what little speed it had across the last step.
    const Vec3 way = system->position(result.last, 0) - origin;
    return std::hypot(way.dot(down) - exact[0], way[1] - exact[1]) / size;
  };
  for (const char* id : {"dop853", "dormand_prince_5", "esdirk4", "tr_bdf2", "rkc2"}) {
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
      RunOptions options;
      options.duration = duration;
      options.tolerance.relative = tolerance;
      // The direction of a slip turns by up to a right angle within the step that ends it. What speed that leaves
      // swings on the slider's spring, once to each side: of tr_bdf2 2e-6 m/s, 2 v sqrt(m / k) = 4e-8 m of 0.09, at any
      // tolerance.
      const double swing = id == std::string("tr_bdf2") ? 5e-7 : 0.0;
      EXPECT_LE(off(id, options), std::max(10.0 * tolerance, swing)) << id << " at " << tolerance;
    }
  }
  for (const char* id : {"velocity_verlet", "backward_euler", "bdf2", "implicit_midpoint", "discrete_gradient"}) {
    RunOptions options;
    options.duration = duration;
    options.h = 0.01;
    options.fixedStep = true;
    // Backward Euler's path is longer or shorter by about v h / 2.
    EXPECT_LE(off(id, options), id == std::string("backward_euler") ? push * options.h / size : 0.01) << id;
  }
}

// The order of a fixed step is the method's own: friction that turns costs none of it.
TEST(SlidingFriction, KeepsTheOrderOfTheMethod) {
  const std::array<double, 4> exact = byCoulomb();
  const Vec3 down(std::cos(angle), 0.0, -std::sin(angle));
  const std::unique_ptr<ModelSystem> system = build(incline());
  const State start = system->initialState();
  const Vec3 origin = system->position(start, 0);
  const auto error = [&](double h) {
    RunOptions options;
    options.duration = duration;
    options.h = h;
    options.fixedStep = true;
    const std::unique_ptr<Integrator> method = makeMethod("runge_kutta_4");
    const RunResult result = simulate(*system, *method, start, options);
    const Vec3 way = system->position(result.last, 0) - origin;
    return std::hypot(way.dot(down) - exact[0], way[1] - exact[1]);
  };
  const double coarse = error(0.02), fine = error(0.01);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

}  // namespace
}  // namespace sliding
}  // namespace muelle::lab
