/// \file
/// A node that slides over an incline and is pushed across it: its path turns, and friction with it. The reference is
/// Coulomb's law integrated on its own by Fehlberg's method of Boost.odeint, in the plane of the incline.

#include "engine/control/motion_frame.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/run/error_estimate.h"

#include <gtest/gtest.h>
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
Model incline() {
  Model model;
  model.gravity = Vec3(0.0, 0.0, -g);
  Obstacle plane;
  plane.normal = Vec3(std::sin(angle), 0.0, std::cos(angle));
  plane.material = {.k = k, .mu = mu};
  model.obstacles.push_back(plane);
  model.nodes.push_back({.x = -g * std::cos(angle) / k * plane.normal, .v = Vec3(0.0, across, 0.0)});
  return model;
}

/// (down, across, their speeds) after `duration`: dv/dt = g sin(angle) down - mu g cos(angle) v / |v|.
std::array<double, 4> byCoulomb() {
  namespace odeint = boost::numeric::odeint;
  using Numbers = std::array<double, 4>;
  Numbers y = {0.0, 0.0, 0.0, across};
  const auto slope = [](const Numbers& at, Numbers& rate, double) {
    const double speed = std::hypot(at[2], at[3]), friction = mu * g * std::cos(angle);
    rate = {at[2], at[3], g * std::sin(angle) - friction * at[2] / speed, -friction * at[3] / speed};
  };
  odeint::integrate_adaptive(odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<Numbers>()), slope, y,
                             0.0, duration, 1e-3);
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
  for (const char* id : {"dop853", "dormand_prince_5"}) {
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
