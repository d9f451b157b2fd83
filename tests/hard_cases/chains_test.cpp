/// \file
/// H05, H09, H10, H12 and the static half of H14 and H16: many nodes, equilibria, spectra, mass ratios.

#include "engine/integrators/catalogue.h"
#include "engine/integrators/position_based/methods.h"
#include "engine/solve/dense.h"
#include "engine/solve/linear_solver.h"
#include "engine/statics/equilibrium.h"
#include "lab/hard_cases/models.h"
#include "lab/hard_cases/references.h"
#include "lab/hard_cases/running.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace muelle::hard_cases {
namespace {

engine::SystemMatrix stiffness(const engine::ModelSystem& system, const State& state) {
  engine::SystemMatrix K;
  system.linearisation()->assemble(0, 0, 1, state.t, state.x, state.v, state.z, engine::Form::Exact, K);
  return K;
}

// ---------------------------------------------------------------------------------------------------------------- H05

double meanOf(const Finished& end, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += end.x(i)[2];
  return sum / n;
}

TEST(H05MeanHeight, ForceEnergyAndRank) {
  const auto system = engine::build(meanHeight(1000));
  const State start = system->initialState();
  std::vector<double> f(start.x.size());
  system->force(0.0, start.x, start.v, start.z, f);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(i, 2))], reference("H05", "force_per_node(0)"), 1e-14);
  }
  EXPECT_NEAR(system->totalEnergy(start), reference("H05", "E(0)"), 1e-11);
  const engine::SystemMatrix K = stiffness(*system, start);
  ASSERT_EQ(K.lowRank.s.size(), 1);
  EXPECT_NEAR(K.lowRank.s[0] * K.lowRank.U.squaredNorm(), reference("H05", "hessian_nonzero_eig"), 1e-14);
  EXPECT_EQ(K.sparse.norm(), 0.0) << "nothing of the property is assembled";
}

TEST(H05MeanHeight, ImplicitMidpointFollowsItsDiscreteForm) {
  const double h = 0.01, turn = 2.0 * std::atan(0.5 * h * reference("H05", "omega"));
  const Finished end = run(meanHeight(1000), "implicit_midpoint", fixedStep(h, 1.0));
  const double start = reference("H05", "hbar(0)") - 1.0;
  EXPECT_NEAR(meanOf(end, 1000), 1.0 + start * std::cos(100 * turn), 1e-12);
  // Every node moves by the same amount.
  EXPECT_NEAR(end.x(999)[2] - end.x(0)[2], 0.999, 1e-12);
}

TEST(H05MeanHeight, KahanLiReachesTheExactMean) {
  const Finished end = run(meanHeight(1000), "kahan_li_8", fixedStep(0.01, 1.0));
  EXPECT_NEAR(meanOf(end, 1000), reference("H05", "hbar(1)"), 1e-10);
  EXPECT_NEAR(end.x(0)[2], reference("H05", "z0(1)"), 1e-10);
  EXPECT_NEAR(end.v(0)[2], reference("H05", "vz(1)"), 1e-9);
}

TEST(H05MeanHeight, ImplicitStepOfAHundredThousandNodesIsLinearInTheirNumber) {
  constexpr int n = 100'000;
  const auto system = engine::build(meanHeight(n));
  const State start = system->initialState();
  const engine::SystemMatrix K = stiffness(*system, start);
  EXPECT_LE(K.sparse.nonZeros(), 9 * n) << "diagonal blocks at most";
  EXPECT_EQ(K.lowRank.U.size(), 3 * n);
  // In force evaluations, which no machine changes: the case's 10 ms are 20 of them.
  for (const char* id : {"backward_euler", "implicit_midpoint"}) {
    const auto method = engine::makeMethod(id);
    method->prepare(*system, {});
    State end = start;
    ASSERT_TRUE(method->step(*system, start, 0.01, end).done) << id;
    EXPECT_LE(method->work().forceEvaluations, 20) << id;
    EXPECT_LE(method->work().factorisations, 3) << id;
  }
}

// ---------------------------------------------------------------------------------------------------------------- H09

TEST(H09HangingChain, EquilibriumOfTheVerticalChain) {
  const auto system = engine::build(hangingChain());
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  ASSERT_TRUE(rest.converged) << rest.message;
  EXPECT_NEAR(system->position(rest.state, 99)[0], reference("H09", "vertical.z100"), 1e-12);
  EXPECT_NEAR(system->position(rest.state, 49)[0], reference("H09", "vertical.z50"), 1e-12);
  EXPECT_NEAR(1000.0 * (-system->position(rest.state, 0)[0] - 0.01), reference("H09", "vertical.top_tension"), 1e-9);
}

TEST(H09HangingChain, EquilibriumOfTheCatenaryFromAStraightLine) {
  // Straight, the springs are compressed to 0.05 and push the line out of itself: the stiffness is indefinite.
  const auto system = engine::build(catenary(0.0));
  const State start = system->initialState();
  engine::LinearSolver solver;
  const engine::SystemMatrix K = stiffness(*system, start);
  EXPECT_FALSE(solver.factorise(K, true).usable);
  const engine::StaticResult rest = engine::equilibrium(*system, start);
  ASSERT_TRUE(rest.converged) << rest.message;
  EXPECT_NEAR(system->position(rest.state, 9)[2], reference("H09", "catenary.mid_z"), 1e-12);
  EXPECT_NEAR(system->position(rest.state, 4)[0], reference("H09", "catenary.x5"), 1e-12);
  EXPECT_NEAR(system->position(rest.state, 4)[2], reference("H09", "catenary.z5"), 1e-12);
  EXPECT_NEAR(rest.energy, reference("H09", "catenary.Etot"), 1e-11);
}

TEST(H09HangingChain, DampedMotionComesToTheSamePoint) {
  const Finished chain = run(hangingChain(10.0), "runge_kutta_4", fixedStep(4e-3, 6.0));
  EXPECT_NEAR(chain.x(99)[0], reference("H09", "vertical.z100"), 1e-8);
  for (const char* id : {"backward_euler", "velocity_verlet"}) {
    const Finished end = run(catenary(0.1, 6.0), id, fixedStep(5e-3, 10.0));
    EXPECT_NEAR(end.x(9)[2], reference("H09", "catenary.mid_z"), 1e-8) << id;
    EXPECT_NEAR(end.x(4)[0], reference("H09", "catenary.x5"), 1e-8) << id;
  }
}

TEST(H09HangingChain, FewProjectionsOverstretchTheChain) {
  const auto few = engine::xpbd(1);
  const Finished end = run(hangingChain(10.0), *few, fixedStep(1.0 / 60, 10.0));
  EXPECT_LT(end.x(99)[0], reference("H09", "vertical.z100") - 0.05);
}

// ---------------------------------------------------------------------------------------------------------------- H10

/// Eigenvalues of the stiffness matrix, ascending.
Eigen::VectorXd spectrum(const Model& model) {
  const auto system = engine::build(model);
  const engine::SystemMatrix K = stiffness(*system, system->initialState());
  return engine::symmetricEigenvalues(K.sparse);
}

double modeEigenvalue(double c, int j) {
  const double s = std::sin(j * std::numbers::pi / 102.0);
  return 4.0 * c * s * s;
}

TEST(H10ChainWaves, StiffnessHasTheSquaredFrequencies) {
  const Eigen::VectorXd along = spectrum(longitudinalChain());
  for (int j = 1; j <= 50; ++j) EXPECT_LT(relative(along[j - 1], modeEigenvalue(100.0, j)), 1e-10) << j;
  EXPECT_LT(relative(std::sqrt(along[0]), reference("H10", "longitudinal.omega1")), 1e-10);
  EXPECT_LT(relative(std::sqrt(along[49]), reference("H10", "longitudinal.omega50")), 1e-10);
  // Across the line only the term k (1 - L0/L) acts: the line itself, without the start's wave.
  Model straight = transverseChain();
  for (engine::ModelNode& node : straight.nodes) node.x[2] = 0.0;
  std::vector<double> expected;
  for (int j = 1; j <= 50; ++j) {
    expected.push_back(modeEigenvalue(100.0, j));
    expected.push_back(modeEigenvalue(100.0 * 0.1 / 1.1, j));
  }
  std::ranges::sort(expected);
  const Eigen::VectorXd both = spectrum(straight);
  for (Eigen::Index j = 0; j < both.size(); ++j) {
    EXPECT_LT(relative(both[j], expected[static_cast<std::size_t>(j)]), 1e-10) << j;
  }
}

TEST(H10ChainWaves, AtRestLengthNothingHoldsItAcross) {
  Model slack = transverseChain();
  for (engine::ModelNode& node : slack.nodes) node.x = Vec3(node.x[0] / 1.1, 0, 0);
  const auto system = engine::build(slack);
  const engine::SystemMatrix K = stiffness(*system, system->initialState());
  engine::LinearSolver solver;
  const engine::Factorisation found = solver.factorise(K);
  EXPECT_FALSE(found.definite);
  EXPECT_TRUE(!found.usable || found.vanishing > 0);
}

/// Largest error of the four nodes with references at t = 10, relative to the wave's height.
double waveError(const Finished& end, const std::string& kind, int axis, double height) {
  double largest = 0.0;
  for (const int i : {1, 13, 25, 50}) {
    const double rest = axis == 0 ? i : 0.0;
    const double expected = reference("H10", kind + std::to_string(i) + "(10)");
    largest = std::max(largest, std::abs(end.x(i - 1)[axis] - rest - expected));
  }
  return largest / height;
}

TEST(H10ChainWaves, LongitudinalWave) {
  const Model model = longitudinalChain();
  EXPECT_LT(waveError(run(model, "kahan_li_8", fixedStep(0.025, 10.0)), "longitudinal.u", 0, 1.0), 1e-8);
  EXPECT_LT(waveError(run(model, "kahan_li_8", fixedStep(0.0125, 10.0)), "longitudinal.u", 0, 1.0), 1e-10);
}

TEST(H10ChainWaves, TransverseWave) {
  const Finished end = run(transverseChain(), "kahan_li_8", fixedStep(0.025, 10.0));
  // Linear theory neglects (slope)^2 k/T, 4e-14 of the wave; the engine's rounding is that of the places, 1e-16 of 25 m
  // against 1e-6 m, but it moves along the line only.
  EXPECT_LT(waveError(end, "transverse.z", 2, 1e-6), 1e-13);
  EXPECT_LT(waveError(end, "transverse.nonlinear.z", 2, 1e-6), 1e-13);
  for (const int i : {1, 13, 25, 50}) {
    const std::string name = "transverse.nonlinear.vz" + std::to_string(i) + "(10)";
    EXPECT_NEAR(end.v(i - 1)[2], reference("H10", name), 1e-19) << name;
  }
}

// ---------------------------------------------------------------------------------------------------------------- H12

double bounceError(const Finished& end) { return std::abs(end.x(1)[0] - reference("H12", "one_d.z2(1)")); }
double swingError(const Finished& end) {
  return std::hypot(end.x(1)[0] - reference("H12", "swing.x2(1)"), end.x(1)[2] - reference("H12", "swing.z2(1)"));
}

TEST(H12HeavyBelowLight, Equilibrium) {
  const auto system = engine::build(heavyBelowLight());
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  ASSERT_TRUE(rest.converged) << rest.message;
  EXPECT_LT(relative(system->position(rest.state, 0)[0], reference("H12", "static.z1")), 1e-12);
  EXPECT_LT(relative(system->position(rest.state, 1)[0], reference("H12", "static.z2")), 1e-12);
}

TEST(H12HeavyBelowLight, EnergiesAndPeriod) {
  for (const auto& [model, name] : {std::pair(heavyBelowLight(), "one_d.E"), std::pair(heavySwing(), "swing.E")}) {
    const auto system = engine::build(model);
    EXPECT_LT(relative(system->totalEnergy(system->initialState()), reference("H12", name)), 1e-15) << name;
  }
  const auto system = engine::build(heavyBelowLight());
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  EXPECT_LT(relative(rest.energy, reference("H12", "static.E")), 1e-14);
  // Verlet's modified energy differs by the fast mode's 1e-7 m: (h omega)^2/4 of what swings in it.
  const Finished swing = run(heavySwing(), "velocity_verlet", fixedStep(1.0 / 8000, 1.0));
  EXPECT_LT(relative(swing.energy(), reference("H12", "swing.E")), 1e-8);
  // After a slow period the heavy node is back where it was let go, but for the fast mode's 1e-7 m.
  const double period = reference("H12", "one_d.period");
  const Finished back = run(heavyBelowLight(), "velocity_verlet", fixedStep(period / 8000, period));
  EXPECT_NEAR(back.x(1)[0], -2.0, 2e-7);
}

TEST(H12HeavyBelowLight, ImplicitMidpointAtFrameRate) {
  EXPECT_LT(bounceError(run(heavyBelowLight(), "implicit_midpoint", fixedStep(1.0 / 60, 1.0))), 2e-3);
  EXPECT_LT(swingError(run(heavySwing(), "implicit_midpoint", fixedStep(1.0 / 60, 1.0))), 1e-3);
}

TEST(H12HeavyBelowLight, VerletInsideItsLimit) {
  const Finished fine = run(heavySwing(), "velocity_verlet", fixedStep(1.0 / 8000, 1.0));
  EXPECT_LT(swingError(fine), 5e-8);
  for (const char* id : {"symplectic_euler", "velocity_verlet"}) {
    const Finished coarse = run(heavySwing(), id, fixedStep(1.0 / 7000, 1.0));
    EXPECT_FALSE(coarse.x(0).norm() < 1e3) << id << ": 1/7000 lies beyond the limit of 1.41421e-4";
  }
}

TEST(H12HeavyBelowLight, BackwardEulerIsFourCentimetresOff) {
  EXPECT_NEAR(bounceError(run(heavyBelowLight(), "backward_euler", fixedStep(1.0 / 60, 1.0))), 0.044, 0.003);
}

TEST(H12HeavyBelowLight, XpbdFallsThrough) {
  const auto frames = engine::xpbd(1);
  const Finished end = run(heavyBelowLight(), *frames, fixedStep(1.0 / 60, 1.0));
  EXPECT_LT(end.x(1)[0], -4.0) << "the heavy node falls nearly freely";
  const auto substeps = engine::xpbd(1000);
  EXPECT_LT(bounceError(run(heavyBelowLight(), *substeps, fixedStep(1.0 / 60, 1.0))), 2e-2);
}

// ---------------------------------------------------------------------------------------------------------- H14 static

TEST(H14Buckling, EquilibriumIsOnTheRing) {
  for (const double offset : {1e-6, 1e-3, 0.0}) {
    const auto system = engine::build(buckling(100.0, offset));
    const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
    ASSERT_TRUE(rest.converged) << rest.message;
    const Vec3 x = system->position(rest.state, 0);
    EXPECT_NEAR(std::hypot(x[1], x[2]), reference("H14", "ring_radius"), 1e-12);
    EXPECT_NEAR(x[0], 0.0, 1e-12);
    EXPECT_LE(rest.energy, 1e-20);
  }
}

// Not the engine: Newton's method on the forces alone.
TEST(H14Buckling, PlainNewtonConvergesToTheSaddle) {
  const auto system = engine::build(buckling(100.0, 1e-3));
  State state = system->initialState();
  Eigen::VectorXd f(state.x.size());
  for (int i = 0; i < 5; ++i) {
    system->force(0.0, state.x, state.v, state.z, {f.data(), state.x.size()});
    const Eigen::MatrixXd K(stiffness(*system, state).sparse);
    Eigen::Map<Eigen::Vector3d>(state.x.data()) += engine::solveFullPivoting(K, f.head<3>());  // one free node: first
  }
  EXPECT_LT(std::abs(state.x[1]), 1e-12);
  EXPECT_NEAR(system->totalEnergy(state), reference("H14", "E_saddle"), 1e-12);
}

// ---------------------------------------------------------------------------------------------------------- H16 static

TEST(H16StiffCloth, HangsInAMinimumNotInThePlanarSaddle) {
  const auto system = engine::build(cloth());
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  ASSERT_TRUE(rest.converged) << rest.message;
  EXPECT_LE(rest.energy, -0.441773);
  EXPECT_LT(rest.energy, reference("H16", "static.planar_saddle.E"));
  EXPECT_GE(rest.smallestEigenvalue, -1e-6);
}

}  // namespace
}  // namespace muelle::hard_cases
