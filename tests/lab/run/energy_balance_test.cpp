#include "lab/run/energy_balance.h"

#include "lab/run/run_scene.h"

#include "../random/dice.h"
#include "engine/analysis/amplification.h"
#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "support/scene_text.h"

#include <gmock/gmock.h>
#include <cmath>

namespace muelle::lab {

using namespace engine;
namespace {

/// 1 kg on a spring of 100 N/m (omega = 10 / s), 0.2 m from its rest length: 2 J.
Scene swinging(const char* method, double hOmega, double duration) {
  Scene scene = sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\n" + run);
  scene.method = method;
  scene.step = hOmega / 10.0;
  scene.duration = duration;
  return scene;
}

/// 1 kg, 1 m above a plane of 1e5 N/m (omega = 316 / s).
Scene bouncing(const char* method, double h) {
  Scene scene = sceneFrom(
      "title = 'A test'\nshows = 'nothing'\nslide = 'Contacto Externo'\ndimension = 1\ngravity = 9.81\n"
      "[[node]]\nx = 1.0\nm = 1.0\n[[obstacle]]\nshape = 'plane'\nname = 'ground'\npoint = 0.0\nk = "
      "1e5\n" +
      engine::run);
  scene.method = method;
  scene.step = h;
  scene.duration = 10.0;
  return scene;
}

EnergyBalance balanceOf(const Scene& scene) { return runScene(scene).energy; }

TEST(EnergySwing, IsThatOfTheModifiedEnergy) {
  for (const double z : {0.1, 0.5, 1.0, 1.5, 1.9}) {
    const auto swing = [z](const char* id) {
      const auto method = makeMethod(id);
      return Amplification(*method).energySwing(z);
    };
    // Verlet keeps v^2 + (1 - z^2/4) w^2 x^2, symplectic Euler v^2 +- z w x v + w^2 x^2.
    EXPECT_NEAR(swing("velocity_verlet"), 1.0 / (1.0 - z * z / 4.0), 1e-9) << z;
    EXPECT_NEAR(swing("symplectic_euler"), (1.0 + z / 2.0) / (1.0 - z / 2.0), 1e-9) << z;
    EXPECT_NEAR(swing("implicit_midpoint"), 1.0, 1e-9) << z;
    EXPECT_EQ(swing("explicit_euler"), 1.0) << z;
  }
}

// Stable runs never fail, however near the limit: what their method keeps is its own energy.
TEST(EnergyBalance, OfAStableRunOfTheStudentsMethodsHolds) {
  for (const char* method : {"velocity_verlet", "symplectic_euler"}) {
    for (const double hOmega : {0.1, 1.0, 1.5, 1.9, 1.98}) {
      const EnergyBalance balance = balanceOf(swinging(method, hOmega, 100.0));
      EXPECT_FALSE(balance.fails()) << method << " " << hOmega;
    }
  }
}

TEST(EnergyBalance, OfARunThatGrowsFails) {
  EXPECT_TRUE(balanceOf(swinging("explicit_euler", 0.2, 20.0)).fails());
  EXPECT_TRUE(balanceOf(swinging("velocity_verlet", 2.02, 20.0)).fails());
  for (const double h : {0.008, 0.02, 0.05}) {
    EXPECT_TRUE(balanceOf(bouncing("symplectic_euler", h)).fails()) << h;
  }
  EXPECT_TRUE(balanceOf(bouncing("velocity_verlet", 0.008)).fails());
  EXPECT_FALSE(balanceOf(bouncing("velocity_verlet", 0.0005)).fails());
  EXPECT_THAT(energyFailure(balanceOf(bouncing("velocity_verlet", 0.008))),
              ::testing::HasSubstr("the energy rises by"));
}

/// One to three balls on springs, one upon another, over a ground and, each third, beside a ball that it may hit. Off
/// the line springs are so soft that the ground sets the limit: a spring that turns is no linear system, and near its
/// own limit its energy may grow for good.
Scene randomBounce(Dice& dice, const char* method) {
  Scene scene;
  scene.method = method;
  Model& model = scene.model;
  model.dimension = 1 + dice.below(3);
  const int up = model.dimension == 1 ? 0 : 2, count = 1 + dice.below(3);
  const double stiffness = dice.logarithmic(1e3, 1e6);
  model.gravity = Vec3::Zero();
  model.gravity[up] = -9.81;
  for (int i = 0; i < count; ++i) {
    ModelNode node{.v = dice.vector(model.dimension, 2.0), .m = dice.logarithmic(0.1, 10.0)};
    node.x = dice.vector(model.dimension, 0.1);
    node.x[up] += dice.uniform(0.2, 1.0) + i;
    model.nodes.push_back(node);
    const double k = stiffness * (model.dimension == 1 ? dice.logarithmic(1e-3, 10.0) : dice.logarithmic(1e-3, 0.03));
    if (i > 0) model.springs.push_back({.a = i - 1, .b = i, .k = k, .L0 = 1.0});
  }
  const auto add = [&](Obstacle obstacle) {
    obstacle.material.k = stiffness;
    model.obstacles.push_back(obstacle);
  };
  Obstacle ground;
  ground.normal = Vec3::Zero();
  ground.normal[up] = 1.0;
  if (model.dimension > 1) ground.normal[0] = dice.uniform(-0.2, 0.2);
  ground.normal.normalize();
  add(ground);
  if (model.dimension > 1 && dice.chance(0.33)) {
    add({.kind = Obstacle::Kind::Sphere, .name = "ball", .centre = Vec3(0.4, 0.0, 0.0), .radius = 0.3});
  }
  scene.locateEvents = dice.chance(0.7);
  for (ModelSpring& spring : model.springs) spring.isSigned = model.dimension == 1 && !scene.locateEvents;
  return scene;
}

/// With a step of this part of the limit that is told, over 20 seconds or 20,000 steps.
EnergyBalance bounced(Scene scene, double part) {
  const std::unique_ptr<ModelSystem> system = build(scene.model);
  const std::unique_ptr<Integrator> method = makeMethod(scene.method);
  scene.step = part * stability(*system, *method, system->initialState()).largestStep;
  scene.duration = std::min(20.0, 20'000.0 * *scene.step);
  return balanceOf(scene);
}

// Each bounce multiplies the energy by up to 1 / (1 - (h omega)^2 / 4), up or down: they walk at random, and a step
// that is within the limit shows gains of any size where there are many.
TEST(EnergyBalance, OfBouncesByAStableStepHolds) {
  int rose = 0;
  for (const char* method : {"velocity_verlet", "symplectic_euler"}) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      Dice dice(seed);
      const Scene scene = randomBounce(dice, method);
      const double part = seed % 4 == 0 ? dice.uniform(0.8, 0.99) : dice.logarithmic(0.01, 0.99);
      const EnergyBalance balance = bounced(scene, part);
      EXPECT_FALSE(balance.fails()) << method << ", seed " << seed << ", at " << part
                                    << " of the limit: " << energyFailure(balance) << ", " << balance.allowed
                                    << " J allowed";
      if (balance.highest > 0.05 * balance.scale) ++rose;
    }
  }
  EXPECT_GE(rose, 20) << "else the test shows nothing";
}

TEST(EnergyBalance, OfBouncesByAnUnstableStepFails) {
  int failed = 0, all = 0;
  for (const char* method : {"velocity_verlet", "symplectic_euler"}) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      Dice dice(seed);
      const Scene scene = randomBounce(dice, method);
      const EnergyBalance balance = bounced(scene, dice.logarithmic(1.2, 8.0));
      ++all;
      if (balance.fails()) ++failed;
    }
  }
  // The others do not meet what they are unstable on, or lose at their bounces.
  EXPECT_GE(failed, 9 * all / 10);
}

// One node has no extent. Falling for a second, explicit Euler gains m g^2 h t / 2 = 0.48 J, 1 % of what gravity does.
TEST(EnergyBalance, OfALoneNodeIsMeasuredByItsWay) {
  const std::string down =
      "title = 'A test'\nshows = 'nothing'\nslide = 'Contacto Externo'\ndimension = 1\ngravity = 9.81\n";
  Scene falling = sceneFrom(down + "[[node]]\nx = 0.0\nm = 1.0\n" + run);
  falling.method = "explicit_euler";
  const EnergyBalance balance = balanceOf(falling);
  EXPECT_NEAR(balance.highest, 0.5 * 9.81 * 9.81 * 0.01, 1e-9);
  EXPECT_FALSE(balance.fails());
  // In touch with a ground of 1e5 N/m, whose limit is 2 / sqrt(k / m) = 6.3e-3 s.
  Scene touching = bouncing("velocity_verlet", 1e-3);
  touching.model.nodes[0].x[0] = 0.0;
  EXPECT_FALSE(balanceOf(touching).fails());
  touching.step = 1e-2;
  EXPECT_TRUE(balanceOf(touching).fails());
}

// A stiff pendulum by steps that the outputs do not meet: the cubic between two steps leaves the circle by some
// (h v / L)^4 L / 384 = 3e-5 m, and a spring of 1e11 N/m takes 45 J for that, four times what the scene has.
TEST(EnergyBalance, IsJudgedByEndsOfStepsNotByWhatIsInterpolatedBetween) {
  Scene scene = sceneFrom(
      "title = 'A test'\nshows = 'nothing'\nslide = 'Contacto Externo'\ngravity = 9.81\n"
      "[[node]]\nx = [0.0, 0.0, 0.0]\nm = 1.0\n[[node]]\nx = [1.0, 0.0, 0.0]\nm = 1.0\n[[pin]]\nnodes = [0]\n"
      "[[spring]]\nnodes = [0, 1]\nk = 1e11\nL0 = 1.0\n" +
      run);
  scene.method = "tr_bdf2";
  scene.step = 0.1;
  scene.duration = 1.0;
  scene.outputInterval = 0.03;
  const EnergyBalance balance = balanceOf(scene);
  ASSERT_TRUE(balance.interpolated);
  EXPECT_GT(*balance.interpolated, balance.scale);
  EXPECT_FALSE(balance.fails());
  scene.method = "explicit_euler";
  scene.step = 0.01;
  scene.model.springs[0].k = 1e4;
  EXPECT_TRUE(balanceOf(scene).fails()) << "a gain at the ends of steps is one";
}

// A scene that something drives may gain.
TEST(EnergyBalance, OfADrivenSceneNeverFails) {
  Scene scene = sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\n[[force]]\nnodes = [1]\n" +
                          "F = 50.0\nfrequency = 1.6\n" + run);
  scene.duration = 5.0;
  const EnergyBalance balance = balanceOf(scene);
  EXPECT_EQ(balance.fate, EnergyFate::Open);
  EXPECT_GT(balance.highest, balance.scale);
  EXPECT_FALSE(balance.fails());
}

// 1 km up, or flying by at 1e4 m/s: the same scale and the same balance, to the rounding of energies of 1e8 J.
TEST(EnergyBalance, DoesNotDependOnTheFrame) {
  const auto scene = [](double x, double v) {
    const std::string nodes = "[[node]]\nx = " + std::to_string(x) + "\nv = " + std::to_string(v + 1.0) +
                              "\nm = 1.0\n[[node]]\nx = " + std::to_string(x + 1.0) + "\nv = " + std::to_string(v) +
                              "\nm = 2.0\n";
    return sceneFrom(head + nodes + "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\n" + engine::run);
  };
  const EnergyBalance here = balanceOf(scene(0.0, 0.0)), there = balanceOf(scene(1000.0, 1e4));
  EXPECT_NEAR(here.scale, 0.5 * (1.0 * 4.0 / 9.0 + 2.0 * 1.0 / 9.0), 1e-12);  // of the relative motion alone
  EXPECT_NEAR(there.scale, here.scale, 1e-8);
  EXPECT_NEAR(there.highest, here.highest, 1e-6);
  EXPECT_NEAR(there.lowest, here.lowest, 1e-6);
}

}  // namespace
}  // namespace muelle::lab
