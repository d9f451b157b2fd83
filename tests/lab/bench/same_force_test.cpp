/// \file
/// The peers' plain loop is the engine's physics, so that a comparison of speeds is one of the same scene.

#include "benchmarks/peers/plain_force.h"
#include "benchmarks/peers/problem.h"
#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::bench {
namespace {

struct Case {
  std::string scene;
  double time;  ///< [s] at which forces are compared: a ball on the ground, a rabbit between its plates
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.scene; }

State stateAt(const engine::ModelSystem& system, double time) {
  const auto method = engine::makeMethod("velocity_verlet");
  engine::StepOptions options;
  options.duration = time;
  options.h = 1e-5;
  options.locateEvents = false;
  engine::Simulation simulation(system, *method, system.initialState(), options);
  while (simulation.advance().goesOn()) {
  }
  return simulation.state();
}

/// Accelerations of all nodes, as velocities of a path's point.
std::vector<double> engineAccelerations(const engine::ModelSystem& system, const State& state) {
  State shown = state;
  system.acceleration(state.t, state.x, state.v, state.z, shown.v);
  return pointOf(system, shown).v;
}

template <int D>
struct Plain {
  PlainForce<D> force;
  std::vector<double> x, v;

  Plain(const engine::Model& model, const PathPoint& point) : force(model), x(force.size()), v(force.size()) {
    for (std::size_t i = 0; i < force.user().size(); ++i) {
      const std::size_t node = static_cast<std::size_t>(force.user()[i]);
      for (std::size_t c = 0; c < D; ++c) {
        x[D * i + c] = point.x[D * node + c];
        v[D * i + c] = point.v[D * node + c];
      }
    }
  }
  std::vector<double> accelerations(double t) const {
    std::vector<double> a(x.size());
    force(t, x.data(), v.data(), a.data());
    return a;
  }
};

template <int D>
void expectSameForce(const engine::Model& model, const Case& one) {
  const auto system = engine::build(model);
  const State state = stateAt(*system, one.time);
  const Plain<D> plain(model, pointOf(*system, state));
  const std::vector<double> exact = engineAccelerations(*system, state), a = plain.accelerations(state.t);
  double largest = 0.0, off = 0.0;
  for (std::size_t i = 0; i < plain.force.user().size(); ++i) {
    const std::size_t node = static_cast<std::size_t>(plain.force.user()[i]);
    for (std::size_t c = 0; c < D; ++c) {
      largest = std::max(largest, std::abs(exact[D * node + c]));
      off = std::max(off, std::abs(exact[D * node + c] - a[D * i + c]));
    }
  }
  // Tensions are differences of lengths: k L eps / m of a spring, 1e5 * 0.1 * 1e-16 * 1000 = 1e-9 m/s^2 where the
  // springs are stiffest and lightest, beside accelerations of 10 m/s^2 and more.
  EXPECT_GT(largest, 1.0);
  EXPECT_LT(off, 1e-9 * std::max(10.0, largest)) << "largest acceleration " << largest;
}

class SameForce : public ::testing::TestWithParam<Case> {};

TEST_P(SameForce, OfThePlainLoopAndOfTheEngine) {
  const engine::Model model = makeScene(GetParam().scene).model;
  if (model.dimension == 1) expectSameForce<1>(model, GetParam());
  if (model.dimension == 2) expectSameForce<2>(model, GetParam());
  if (model.dimension == 3) expectSameForce<3>(model, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameForce,
                         ::testing::Values(Case{"oscillator", 0.1}, Case{"pendulum", 0.1}, Case{"chain", 0.01},
                                           Case{"cloth_16", 2e-3}, Case{"damped_cloth_16", 2e-3}, Case{"drum", 2e-3},
                                           Case{"ball", 0.455}, Case{"rabbit", 5e-3}),
                         [](const auto& drawn) { return drawn.param.scene; });

TEST(SameForce, OfVolumesAndOfAPlaneThatIsTouched) {
  engine::Model model = makeScene("jelly").model;
  for (engine::ModelNode& node : model.nodes) node.x[2] -= 0.32;  // its edge is below the ground
  for (engine::ModelNode& node : model.nodes) node.x[0] *= 1.02;  // and it is out of shape
  expectSameForce<3>(model, {"jelly", 1e-4});
}

TEST(SameForce, OfShuffledNodesInTheOrderOfTheScene) {
  const BenchScene scene = makeScene("cloth_32_shuffled");
  const auto system = engine::build(scene.model);
  const PlainProblem<3> problem(scene);
  const PathPoint start = pointOf(*system, system->initialState());
  const PathPoint peers = problem.point(0.0, problem.startX().data(), problem.startV().data());
  EXPECT_EQ(start.x, peers.x);
  std::vector<double> a(problem.size());
  problem.acceleration(0.0, problem.startX().data(), problem.startV().data(), a.data());
  const std::vector<double> shown = problem.point(0.0, problem.startX().data(), a.data()).v;
  const std::vector<double> exact = engineAccelerations(*system, system->initialState());
  // As above: 1e5 N/m, 1e-3 kg.
  EXPECT_LT(largestNodeDistance(shown, exact, 3), 1e-9 * 1e4);
}

/// The peers' matrix against differences of their own slope.
template <class Problem>
void expectRightMatrix(const Problem& problem, const std::vector<double>& x, const std::vector<double>& v) {
  const std::size_t n = problem.size();
  std::vector<double> matrix(2 * n * 2 * n);
  problem.jacobian(0.0, x.data(), v.data(),
                   [&](std::size_t row, std::size_t column, double value) { matrix[row * 2 * n + column] += value; });
  std::vector<double> y(2 * n), above(n), below(n);
  std::copy(x.begin(), x.end(), y.begin());
  std::copy(v.begin(), v.end(), y.begin() + static_cast<std::ptrdiff_t>(n));
  double off = 0.0, largest = 0.0;
  for (std::size_t j = 0; j < 2 * n; ++j) {
    const double kept = y[j], step = 1e-6;
    y[j] = kept + step;
    problem.acceleration(0.0, y.data(), y.data() + n, above.data());
    y[j] = kept - step;
    problem.acceleration(0.0, y.data(), y.data() + n, below.data());
    y[j] = kept;
    for (std::size_t i = 0; i < n; ++i) {
      const double value = matrix[(n + i) * 2 * n + j];
      // Lanes that are no unknowns move nothing.
      off = std::max(off, std::abs(value - (above[i] - below[i]) / (2.0 * step)));
      largest = std::max(largest, std::abs(value));
    }
  }
  // Central differences: third derivatives of order k / (m L^2) times 1e-12, and rounding of accelerations by 1e-16 of
  // k L / m over 1e-6.
  EXPECT_LT(off, 1e-6 * largest);
}

TEST(PeersMatrix, IsTheDerivativeOfTheirSlope) {
  BenchScene scene = makeScene("chain");
  scene.model.nodes.resize(8);
  scene.model.springs.resize(7);
  scene.model.springs[3].dRelative = 0.2;
  for (std::size_t i = 0; i < 8; ++i) scene.model.nodes[i].x[0] += 1e-3 * static_cast<double>(i * i % 5);
  const PlainProblem<3> plain(scene);
  expectRightMatrix(plain, plain.startX(), plain.startV());
}

TEST(PeersMatrix, OfRowBIsThatOfTheEngine) {
  BenchScene scene = makeScene("pendulum");
  scene.model.nodes[1].v = {0.3, 0, 0.5};
  scene.model.springs[0].dProjected = 0.4;
  const auto system = engine::build(scene.model);
  const KernelProblem kernel(scene, *system);
  std::vector<double> x = kernel.startX(), v = kernel.startV();
  const std::size_t n = kernel.size();
  std::vector<double> matrix(2 * n * 2 * n);
  kernel.jacobian(0.0, x.data(), v.data(),
                  [&](std::size_t row, std::size_t column, double value) { matrix[row * 2 * n + column] += value; });
  // The plain problem has the two free lanes only, in the order of the axes.
  const PlainProblem<2> plain(scene);
  std::vector<double> other(16);
  plain.jacobian(0.0, plain.startX().data(), plain.startV().data(),
                 [&](std::size_t row, std::size_t column, double value) { other[row * 4 + column] += value; });
  for (const int r : {0, 2}) {
    for (const int c : {0, 2}) {
      const auto row = static_cast<std::size_t>(system->unknown(1, r)),
                 column = static_cast<std::size_t>(system->unknown(1, c));
      const auto i = static_cast<std::size_t>(r / 2), j = static_cast<std::size_t>(c / 2);
      EXPECT_NEAR(matrix[(n + row) * 2 * n + column], other[(2 + i) * 4 + j], 1e-11);
      EXPECT_NEAR(matrix[(n + row) * 2 * n + n + column], other[(2 + i) * 4 + 2 + j], 1e-13);
    }
  }
}

}  // namespace
}  // namespace muelle::bench
