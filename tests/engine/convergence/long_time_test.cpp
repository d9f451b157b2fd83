/// \file
/// What each method keeps over a long run: energy, momentum, angular momentum, as its MethodInfo claims. By default at
/// most 1e5 steps of each; MUELLE_LONG=1 takes 1e5 periods and prints a table.

#include "convergence/scenes.h"
#include "engine/control/simulate.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>

namespace muelle::engine {
namespace {

using namespace testing;

bool isLong() { return std::getenv("MUELLE_LONG") != nullptr; }

class LongTime : public EveryMethod {};
INSTANTIATE_TEST_SUITE_P(Convergence, LongTime, ::testing::ValuesIn(methodIds()), methodName());

/// The largest energy error of the first and of the last tenth of a run.
struct EnergyBand {
  double early = 0.0, late = 0.0, last = 0.0;
};

EnergyBand energyBand(Integrator& method, const ModelSystem& system, const State& start, double h, long long steps) {
  const double initial = system.totalEnergy(start);
  EnergyBand band;
  long long n = 0;
  run(method, system, start, h, steps, [&](const State& state) {
    band.last = system.totalEnergy(state) - initial;
    ++n;
    if (10 * n <= steps) band.early = std::max(band.early, std::abs(band.last));
    if (10 * n > 9 * steps) band.late = std::max(band.late, std::abs(band.last));
  });
  return band;
}

// The 1D oscillator, 25 steps a period. Amplification per step decides: a symplectic or reversible method keeps its
// band; the others multiply the energy by |R(ih)|^2 a step, which the first step shows.
TEST_P(LongTime, EnergyOfTheOscillator) {
  const ExactScene scene = oscillator();
  const std::unique_ptr<Integrator> method = makeMethod(GetParam());
  const MethodInfo& info = method->info();
  const double h = 2.0 * 3.14159265358979323846 / 25.0;
  const double initial = scene.system->totalEnergy(scene.start);
  const long long steps = isLong() ? 2'500'000 : 5'000;
  if (info.stability == Stability::Never) {
    const EnergyBand band = energyBand(*method, *scene.system, scene.start, h, 500);
    EXPECT_GT(band.last, 0.0) << "20 periods";  // RKC2 and the midpoint rule grow slowly, explicit Euler at once
    return;
  }
  const EnergyBand band = energyBand(*method, *scene.system, scene.start, h, steps);
  if (isLong()) {
    fmt::print("{:26} {:9.2e} {:9.2e} {:+9.2e}\n", GetParam(), band.early / initial, band.late / initial,
               band.last / initial);
  }
  const double roundOff = 1e-15 * static_cast<double>(steps);
  if (info.symplectic || info.reversible) {
    EXPECT_LT(band.late, 1.01 * band.early + roundOff);
    EXPECT_LT(band.late, h * initial);  // symplectic Euler's is the widest: E + h x v / 2 is what it keeps
  } else {
    EXPECT_LT(band.last, roundOff) << "a stable method that is not symplectic does not gain energy here";
    EXPECT_GT(band.last, -initial * (1.0 + 1e-12));
  }
}

// H08: momentum and angular momentum of a free system.
TEST_P(LongTime, MomentaOfTheFreeTriangle) {
  const std::unique_ptr<ModelSystem> system = build(freeTriangleModel());
  const std::unique_ptr<Integrator> method = makeMethod(GetParam());
  const MethodInfo& info = method->info();
  if (!info.conservesMomentum && !info.conservesAngularMomentum) return;
  const State start = system->initialState();
  const Vec3 P = system->momentum(start), L = system->angularMomentum(start);
  double momentum = 0.0, angular = 0.0;
  // An unstable method has no long run. In a long one the triangle flies far, and the angular momentum about the origin
  // rounds in proportion to the distance.
  const bool goesFar = isLong() && info.stability != Stability::Never;
  const State end = run(*method, *system, start, 2e-3, goesFar ? 100'000 : 1'000, [&](const State& state) {
    momentum = std::max(momentum, (system->momentum(state) - P).norm());
    angular = std::max(angular, (system->angularMomentum(state) - L).norm());
  });
  EXPECT_NEAR((P - Vec3(-0.1, 0.1, 1.6)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((L - Vec3(0.69, -0.24, 1.32)).norm(), 0.0, 1e-15);
  if (info.conservesMomentum) {
    EXPECT_LE(momentum, 1e-12);
  }
  if (info.conservesAngularMomentum) {
    EXPECT_LE(angular, 1e-12 * std::max(1.0, system->position(end, 0).norm()));
  }
  if (isLong()) fmt::print("{:26} P {:9.2e} L {:9.2e}\n", GetParam(), momentum, angular);
}

// The elastic pendulum over 1e5 steps: the discrete gradient loses nothing but round-off, in units of the larger of the
// energy and the largest kinetic energy.
double discreteGradientError(bool compensated, long long steps) {
  const std::unique_ptr<ModelSystem> system = build(elasticPendulumModel());
  const std::unique_ptr<Integrator> method = makeMethod("discrete_gradient");
  const State start = system->initialState();
  double kinetic = 0.0, error = 0.0;
  const double initial = system->totalEnergy(start);
  RunOptions options;
  options.h = 0.01;
  options.duration = 0.01 * static_cast<double>(steps);
  options.compensated = compensated;
  options.keepStates = false;
  options.checkStability = options.checkNumericalDamping = false;
  options.probes = {{"energy", "J", [&](const State& state) {
                       kinetic = std::max(kinetic, system->kineticEnergy(state));
                       const double now = system->totalEnergy(state);
                       error = std::max(error, std::abs(now - initial));
                       return now;
                     }}};
  const RunResult result = simulate(*system, *method, start, options);
  EXPECT_FALSE(result.failed()) << result.trajectory.stop.message;
  EXPECT_EQ(result.work.steps, steps);
  return error / std::max(std::abs(initial), kinetic);
}

TEST(LongRun, DiscreteGradientKeepsTheEnergyOfTheElasticPendulum) {
  const long long steps = 100'000;
  const double plain = discreteGradientError(false, steps), compensated = discreteGradientError(true, steps);
  EXPECT_LE(plain, 1e-12);
  EXPECT_LE(compensated, 1e-12);
  RecordProperty("plain", fmt::format("{:.2e}", plain));
  RecordProperty("compensated", fmt::format("{:.2e}", compensated));
  if (isLong()) fmt::print("discrete gradient, {} steps: {:.2e}, compensated {:.2e}\n", steps, plain, compensated);
}

// H01 with 1e5 steps (1e5 periods on command): the state after N steps is the discrete closed form x = cos(N theta),
// cos theta = 1 - h^2/2, and the modified energy v^2/2 + (1 - h^2/4) x^2/2 stays.
TEST(LongRun, CompensationKeepsTheModifiedEnergyOfVerlet) {
  Model model;
  model.dimension = 1;
  // The spring's other end is at -10, so that it never passes zero length: k (L - L0) = x.
  model.nodes = {{.x = Vec3(-10.0, 0.0, 0.0), .pinned = true}, {.x = Vec3(1.0, 0.0, 0.0)}};
  model.springs = {{.a = 0, .b = 1, .k = 1.0, .L0 = 10.0}};
  const std::unique_ptr<ModelSystem> system = build(model);
  const long long steps = isLong() ? 6'283'185 : 100'000;
  const double h = 0.1;
  const auto drift = [&](bool compensated) {
    const std::unique_ptr<Integrator> method = makeMethod("velocity_verlet");
    double largest = 0.0;
    RunOptions options;
    options.h = h;
    options.duration = h * static_cast<double>(steps);
    options.compensated = compensated;
    options.keepStates = false;
    options.checkStability = options.checkNumericalDamping = false;
    options.probes = {{"modified energy", "J", [&](const State& state) {
                         const double x = state.x[0], v = state.v[0];
                         const double energy = 0.5 * v * v + 0.5 * (1.0 - h * h / 4.0) * x * x;
                         largest = std::max(largest, std::abs(energy / 0.49875 - 1.0));
                         return energy;
                       }}};
    const RunResult result = simulate(*system, *method, system->initialState(), options);
    EXPECT_FALSE(result.failed()) << result.trajectory.stop.message;
    EXPECT_EQ(result.work.steps, steps);
    const double theta = std::acos(1.0 - h * h / 2.0);
    EXPECT_NEAR(result.last.x[0], std::cos(std::fmod(static_cast<double>(steps) * theta, 2.0 * 3.14159265358979324)),
                1e-6);
    return largest;
  };
  const double naive = drift(false), compensated = drift(true);
  EXPECT_LE(naive, 1e-9);
  EXPECT_LE(compensated, 1e-11);
  if (isLong()) fmt::print("velocity Verlet, {} steps: {:.2e}, compensated {:.2e}\n", steps, naive, compensated);
}

}  // namespace
}  // namespace muelle::engine
