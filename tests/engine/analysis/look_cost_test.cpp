/// \file
/// What the looks at a run's step cost is counted and bounded; where the modes cost too much, a bound from one pass
/// over the springs takes their place, and is one.

#include "engine/analysis/numerical_damping.h"
#include "engine/analysis/stability.h"
#include "engine/control/stability_looks.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "engine/solve/dense.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace muelle::engine {
namespace {

using testing::LinearSystem;

State stillState(int n) {
  const auto size = static_cast<std::size_t>(n);
  return {0.0, std::vector<double>(size, 0.0), std::vector<double>(size, 0.0), {}};
}

/// A chain of springs between two walls, as a matrix.
MatX wallChain(int n, double k) {
  MatX K = MatX::Zero(n, n);
  for (int i = 0; i < n; ++i) K(i, i) = 2.0 * k;
  for (int i = 0; i + 1 < n; ++i) K(i, i + 1) = K(i + 1, i) = -k;
  return K;
}

/// The largest eigenvalue of M^(-1/2) A M^(-1/2), A known by its products.
double largestEigenvalue(const LinearisedSystem& system, void (LinearisedSystem::*product)(In, Out) const) {
  const int n = system.size();
  const std::span<const double> mass = system.system().mass();
  MatX A(n, n);
  std::vector<double> unit(static_cast<std::size_t>(n)), image(unit.size());
  for (int j = 0; j < n; ++j) {
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[static_cast<std::size_t>(j)] = 1.0;
    (system.*product)(unit, image);
    for (int i = 0; i < n; ++i) {
      const auto row = static_cast<std::size_t>(i);
      A(i, j) = image[row] / std::sqrt(mass[row] * mass[static_cast<std::size_t>(j)]);
    }
  }
  return symmetricEigenvalues(0.5 * (A + A.transpose())).maxCoeff();
}

/// A tangle of springs with dampers, drag, a bending angle and a property, masses over four decades.
Model tangle(unsigned seed) {
  std::mt19937 dice(seed);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(dice); };
  Model model;
  model.dimension = 1 + static_cast<int>(seed % 3);
  const int nodes = 7 + static_cast<int>(seed);
  for (int i = 0; i < nodes; ++i) {
    ModelNode node{.x = Vec3(number(-1, 1), number(-1, 1), number(-1, 1)), .m = std::pow(10.0, number(-2, 2))};
    node.pinned = i == 0;
    node.drag = i % 3 == 0 ? number(0.0, 1.0) : 0.0;
    model.nodes.push_back(node);
  }
  for (int i = 0; i < 3 * nodes; ++i) {  // to the next node, to the second and to the third: every pair once
    const int a = i % nodes, b = (a + 1 + i / nodes) % nodes;
    ModelSpring spring{.a = a, .b = b, .k = std::pow(10.0, number(0, 3)), .L0 = number(0.0, 1.0)};
    spring.dProjected = number(0.0, 2.0);
    spring.dRelative = i % 2 == 0 ? number(0.0, 1.0) : 0.0;
    model.springs.push_back(spring);
  }
  if (model.dimension > 1) model.angles.push_back({.nodes = {1, 2, 3}, .k = 5.0});
  model.properties.push_back({.nodes = {1, 2, 4}, .weights = {Vec3::Ones(), Vec3::Ones(), Vec3::Ones()}, .k = 50.0});
  return model;
}

TEST(SpectrumBound, HoldsOnRandomTangles) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const std::unique_ptr<ModelSystem> system = build(tangle(seed));
    const LinearisedSystem linearised(*system, system->initialState());
    const std::optional<SpectrumBound> bound = spectrumBound(linearised);
    ASSERT_TRUE(bound.has_value());
    const double stiffness = largestEigenvalue(linearised, &LinearisedSystem::stiffness);
    const double damping = largestEigenvalue(linearised, &LinearisedSystem::damping);
    const double drag = largestEigenvalue(linearised, &LinearisedSystem::drag);
    constexpr double rounding = 1.0 + 1e-10;
    EXPECT_GE(bound->stiffness * rounding, stiffness) << seed;
    EXPECT_GE((bound->damping + bound->drag) * rounding, damping) << seed;
    EXPECT_NEAR(bound->drag, drag, 1e-10 * drag) << seed;
    // Norms of blocks forget directions: a factor of 3 in 3D, the property's whole norm on top.
    EXPECT_LE(bound->stiffness, 4.0 * stiffness) << seed;
    EXPECT_LE(bound->damping, 4.0 * damping) << seed;
  }
}

TEST(SpectrumBound, IsExactForOneSpringWhateverTheMasses) {
  for (const double ma : {1.0, 0.01, 300.0}) {
    Model model;
    model.nodes = {{.x = Vec3::Zero(), .m = ma}, {.x = Vec3(0.6, 0.0, 0.8), .m = 2.0}};
    model.springs = {{.a = 0, .b = 1, .k = 1e3, .L0 = 1.0, .dProjected = 0.5}};
    const std::unique_ptr<ModelSystem> system = build(model);
    const std::optional<SpectrumBound> bound = spectrumBound(LinearisedSystem(*system, system->initialState()));
    ASSERT_TRUE(bound.has_value());
    const double inverse = 1.0 / ma + 1.0 / 2.0;
    EXPECT_NEAR(bound->stiffness, 1e3 * inverse, 1e-9 * 1e3 * inverse) << ma;
    EXPECT_NEAR(bound->damping, 0.5 * inverse, 1e-9 * 0.5 * inverse) << ma;
    // Then so is the step: 2 / omega for velocity Verlet, without damping.
    const auto verlet = makeMethod("velocity_verlet");
    EXPECT_NEAR(sureStep(*verlet, {.stiffness = bound->stiffness, .unknown = 0}), 2.0 / std::sqrt(1e3 * inverse), 1e-6);
  }
}

TEST(SpectrumBound, ItsStepIsNeverBeyondTheLimit) {
  // Stiff where there is little damping, and the other way round; large enough for K and D to have far more modes than
  // the rim is looked at with.
  const int n = 24;
  MatX K = wallChain(n, 100.0), D = wallChain(n, 0.5);
  K.topLeftCorner(5, 5) *= 20.0;
  D.bottomRightCorner(9, 9) *= 30.0;
  const LinearSystem system(VecX::LinSpaced(n, 0.5, 2.0), 0.5 * (K + K.transpose()), 0.5 * (D + D.transpose()));
  const std::optional<SpectrumBound> bound = spectrumBound(LinearisedSystem(system, stillState(n)));
  ASSERT_TRUE(bound.has_value());
  for (const std::string& id : methodIds()) {
    const MethodInfo& info = methodInfo(id);
    if (info.implicit || info.needs.velocityFreeForce || info.needs.constraints || info.holdsRods) continue;
    const auto method = makeMethod(id);
    const double sure = sureStep(*method, *bound);
    const double limit = stability(system, *method, stillState(n)).largestStep;
    EXPECT_LE(sure, limit) << id;
    EXPECT_GE(sure, info.stability == Stability::Limited ? 0.2 * limit : 0.0) << id;
  }
}

/// Counts what it is asked, and has no matrices.
class Counting : public LinearSystem {
 public:
  using LinearSystem::LinearSystem;
  const Linearisation* linearisation() const override { return nullptr; }
  void force(double t, In x, In v, In z, Out f) const override {
    ++evaluations;
    LinearSystem::force(t, x, v, z, f);
  }
  mutable double evaluations = 0.0;
};

TEST(LookCost, OfEveryEvaluationIsCounted) {
  for (const double damping : {0.0, 0.01}) {
    for (const int n : {3, 30, 300}) {
      const MatX K = wallChain(n, 100.0);
      const Counting system(VecX::Ones(n), K, damping * K);
      const LinearisedSystem linearised(system, stillState(n));
      extremeModes(linearised);
      EXPECT_LE(system.evaluations, extremeModesCost(linearised)) << n;
      EXPECT_GE(system.evaluations, 0.2 * extremeModesCost(linearised)) << n;
      system.evaluations = 0.0;
      std::vector<double> y(static_cast<std::size_t>(n), 0.0);
      y[0] = 1.0;
      modesOf(linearised, y);
      EXPECT_LE(system.evaluations, modesOfCost(linearised)) << n;
    }
  }
}

TEST(LookCost, IsWithinFivePerCentOfTheRunOrTwoHundred) {
  const int n = 300;
  const MatX K = wallChain(n, 100.0);
  for (const char* id : {"velocity_verlet", "runge_kutta_4", "backward_euler"}) {
    for (const double steps : {100.0, 1e4}) {
      const Counting system(VecX::Ones(n), K, 1e-3 * K);
      const auto method = makeMethod(id);
      RunOptions options;
      options.h = 0.05;
      options.fixedStep = true;
      options.duration = steps * options.h;
      State start = stillState(n);
      start.v[7] = 1.0;
      if (method->info().needs.linearisation) continue;
      StabilityLooks looks(system, method->info(), options);
      looks.before(*method, start);
      for (int i = 0; i < 3; ++i) looks.afterSwitch(start);
      EXPECT_LE(system.evaluations, std::max(200.0, 0.05 * steps * method->info().stages)) << id << " " << steps;
      EXPECT_GE(system.evaluations, 40.0) << id << ": nothing was looked at";
    }
  }
}

TEST(LookCost, BeyondItABoundIsToldAsOne) {
  const int n = 300;
  const MatX K = wallChain(n, 100.0);
  const LinearSystem system(VecX::Ones(n), K, 1e-4 * K);
  const auto method = makeMethod("velocity_verlet");
  const LinearisedSystem linearised(system, stillState(n));
  const double sure = sureStep(*method, *spectrumBound(linearised));
  const auto warning = [&](double h, double evaluations) {
    LookBudget budget = LookBudget::ofRun(evaluations);
    return instabilityWarning(system, *method, stillState(n), h, 1e4, budget);
  };
  EXPECT_EQ(warning(0.99 * sure, 1e3), "");
  const std::string said = warning(1.5 * sure, 1e3);
  EXPECT_NE(said.find("may be unstable: velocity Verlet is surely stable up to h = "), std::string::npos) << said;
  EXPECT_NE(said.find("by a bound from one pass over the springs"), std::string::npos) << said;
  // A run that is long enough is looked at in full.
  EXPECT_NE(warning(1.5 * sure, 1e6).find(" s is unstable, growing "), std::string::npos);
}

}  // namespace
}  // namespace muelle::engine
