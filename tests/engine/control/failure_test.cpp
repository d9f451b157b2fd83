#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "support/linear_system.h"
#include "test_methods.h"
#include "test_systems.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::oscillatorAt;

RunOptions plain(double h, double duration) {
  RunOptions options;
  options.h = h;
  options.duration = duration;
  options.checkStability = options.checkNumericalDamping = false;
  return options;
}

/// Two unknowns with a force that turns into NaN on the second one after a time.
class Breaking : public DynamicalSystem {
 public:
  int size() const override { return 2; }
  std::span<const double> mass() const override { return mass_; }
  void force(double t, In x, In, In, Out f) const override {
    f[0] = -x[0];
    f[1] = t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : -x[1];
  }
  std::string unknownName(int i) const override { return fmt::format("node {}, z", i + 7); }

 private:
  std::vector<double> mass_ = {1.0, 1.0};
};

TEST(Failure, NumbersThatAreNotFiniteStopTheRunWithinOneStepAndNameTheUnknown) {
  const Breaking system;
  const State start = {0.0, {1.0, 1.0}, {0.0, 0.0}, {}};
  for (const char* id : {"velocity_verlet", "runge_kutta_4", "dormand_prince_5", "dop853", "yoshida4"}) {
    const auto method = makeMethod(id);
    const RunResult run = simulate(system, *method, start, plain(0.04, 1.0));
    ASSERT_TRUE(run.failed()) << id;
    EXPECT_NE(run.trajectory.stop.message.find("node 8, z"), std::string::npos) << run.trajectory.stop.message;
    EXPECT_NEAR(run.trajectory.stop.t, 0.5, 0.041) << id;
    EXPECT_LE(run.last.t, 0.5 + 1e-6) << id;
    for (const std::vector<double>& x : run.trajectory.x) {
      for (const double value : x) EXPECT_TRUE(std::isfinite(value)) << id;
    }
    EXPECT_EQ(run.trajectory.t.back(), run.last.t) << "the last good state is recorded";
  }
}

TEST(Failure, AStartThatIsNotFiniteIsReportedBeforeAnyStep) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  const RunResult run = simulate(system, *method, oscillatorAt(NAN, 0.0), plain(0.1, 1.0));
  ASSERT_TRUE(run.failed());
  EXPECT_EQ(run.work.steps, 0);
  EXPECT_EQ(run.trajectory.stop.unknown, 0);
}

TEST(Failure, AnUnstableStepIsToldBeforeTheRunAndStoppedBeforeNumbersOverflow) {
  // Hard case H03 at omega h = 2.01.
  const LinearSystem system(100.0, 0.0);
  const auto method = makeMethod("velocity_verlet");
  RunOptions options = plain(0.0201, 20.1);
  options.checkStability = true;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_FALSE(run.warnings.empty());
  EXPECT_NE(run.warnings[0].find("stable here up to h = 0.02 s"), std::string::npos) << run.warnings[0];
  ASSERT_TRUE(run.failed());
  EXPECT_NE(run.trajectory.stop.message.find("explodes"), std::string::npos);
  options.h = 0.0199;
  EXPECT_TRUE(simulate(system, *method, oscillatorAt(1.0, 0.0), options).warnings.empty());
}

TEST(Failure, NumericalDampingIsToldBeforeTheRun) {
  const LinearSystem system(40.0, 1.0);
  const auto method = makeMethod("backward_euler");
  RunOptions options = plain(1.0 / 60.0, 1.0);
  options.checkNumericalDamping = true;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("numerical damping exceeds yours"), std::string::npos);
}

/// A method whose steps above a length fail.
class Refusing : public Integrator {
 public:
  explicit Refusing(double longest) : method_(testing::classicalRungeKutta()), longest_(longest) {}
  const MethodInfo& info() const override { return method_->info(); }
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override {
    method_->prepare(system, tolerance);
  }
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    if (h > longest_) return {false, 0.0, "the residual stays at 1"};
    return method_->step(system, from, h, to);
  }

 private:
  std::unique_ptr<Integrator> method_;
  double longest_;
};

TEST(Failure, AStepThatFailsIsTakenInPiecesAndTheGridIsKept) {
  const LinearSystem system(1.0, 0.0);
  Refusing method(0.03);
  RunOptions options = plain(0.1, 1.0);
  options.outputInterval = 0.1;
  const RunResult run = simulate(system, method, oscillatorAt(1.0, 0.0), options);
  ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
  EXPECT_NEAR(run.last.x[0], std::cos(1.0), 1e-7);
  EXPECT_GT(run.work.rejectedSteps, 0);
  ASSERT_EQ(run.trajectory.t.size(), 11U);
  EXPECT_EQ(run.trajectory.t[3], 0.1 * 3.0);
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("the residual stays at 1"), std::string::npos);
}

TEST(Failure, AStepThatFailsAtEveryLengthStopsTheRunWithTheReason) {
  const LinearSystem system(1.0, 0.0);
  Refusing method(0.0);
  const RunResult run = simulate(system, method, oscillatorAt(1.0, 0.0), plain(0.1, 1.0));
  ASSERT_TRUE(run.failed());
  EXPECT_NE(run.trajectory.stop.message.find("the residual stays at 1"), std::string::npos);
  EXPECT_EQ(run.last.t, 0.0);
}

TEST(Failure, AnErrorEstimateThatNeverComesDownStopsWithTheTime) {
  // A jump in the position: x is thrown at t = 0.5 by a force like 1/(t - 0.5).
  class Singular : public LinearSystem {
   public:
    Singular() : LinearSystem(1.0, 0.0) {}
    void force(double t, In, In, In, Out f) const override { f[0] = 1.0 / ((t - 0.5) * (t - 0.5) * (t - 0.5)); }
  };
  const Singular system;
  const auto method = testing::bogackiShampine();
  RunOptions options = plain(0.0, 1.0);
  options.explosion = 1e300;
  const RunResult run = simulate(system, *method, oscillatorAt(0.0, 0.0), options);
  ASSERT_TRUE(run.failed());
  EXPECT_NEAR(run.trajectory.stop.t, 0.5, 1e-3);
}

TEST(Limits, OfStepsAndForceEvaluationsStopWithAReport) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options = plain(0.1, 10.0);
  options.mostSteps = 5;
  RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_TRUE(run.failed());
  EXPECT_EQ(run.work.steps, 5);
  EXPECT_EQ(run.trajectory.t.size(), 6U);
  options.mostSteps = 1000;
  options.mostForceEvaluations = 40;
  run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_TRUE(run.failed());
  EXPECT_EQ(run.work.forceEvaluations, 40);
}

TEST(Limits, OptionsAndSizesThatMakeNoSenseAreRefused) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  const State start = oscillatorAt(1.0, 0.0);
  const auto refused = [&](auto change) {
    RunOptions options = plain(0.1, 1.0);
    State from = start;
    change(options, from);
    EXPECT_THROW(simulate(system, *method, from, options), std::invalid_argument);
  };
  refused([](RunOptions& o, State&) { o.h = 0.0; });
  refused([](RunOptions& o, State&) { o.h = -1.0; });
  refused([](RunOptions& o, State&) { o.h = NAN; });
  refused([](RunOptions& o, State&) { o.duration = 0.0; });
  refused([](RunOptions& o, State&) { o.duration = INFINITY; });
  refused([](RunOptions& o, State&) { o.h = 1e-13; });
  refused([](RunOptions& o, State&) { o.outputTimes = {0.5, 0.2}; });
  refused([](RunOptions& o, State&) { o.outputTimes = {2.0}; });
  refused([](RunOptions& o, State&) { o.outputInterval = -1.0; });
  refused([](RunOptions& o, State&) { o.explosion = 0.0; });
  refused([](RunOptions& o, State&) { o.probes = {{"x", "m", nullptr}}; });
  refused([](RunOptions&, State& s) { s.x.push_back(0.0); });
  refused([](RunOptions&, State& s) { s.z.push_back(0.0); });
  refused([](RunOptions&, State& s) { s.t = NAN; });
}

TEST(Outputs, DenseOutputIsAsExactAsTheSteps) {
  const LinearSystem system(2.0, 0.0);
  std::vector<double> errors;
  for (const double h : {0.2, 0.1}) {
    const auto method = makeMethod("runge_kutta_4");
    RunOptions options = plain(h, 3.0);
    options.outputInterval = 0.0371;
    const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
    ASSERT_EQ(run.trajectory.t.size(), 82U) << "80 multiples, the start and the end";
    double worst = 0.0;
    for (std::size_t i = 0; i < run.trajectory.t.size(); ++i) {
      worst = std::max(worst, std::abs(run.trajectory.x[i][0] - std::cos(2.0 * run.trajectory.t[i])));
    }
    errors.push_back(worst);
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, 0.3) << errors[0] << " " << errors[1];
}

TEST(Outputs, ProbesMeasureAtEveryOutputAndTheLastStateAloneIsKeptWhenAsked) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  int calls = 0;
  RunOptions options = plain(0.01, 1.0);
  options.probes = {{"position", "m", [&calls](const State& state) {
                       ++calls;
                       return state.x[0];
                     }}};
  options.outputInterval = 0.1;
  RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_EQ(calls, 11);
  ASSERT_EQ(run.trajectory.track("position").size(), 11U);
  EXPECT_NEAR(run.trajectory.track("position")[5], std::cos(0.5), 1e-10);
  options.keepStates = false;
  run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_EQ(calls, 22);
  EXPECT_EQ(run.trajectory.t, std::vector<double>{1.0});
  EXPECT_NEAR(run.trajectory.last().x[0], std::cos(1.0), 1e-10);
}

/// Largest relative drift of Verlet's modified energy v^2/2 + (1 - h^2/4) x^2 / 2 (hard case H01).
double modifiedEnergyDrift(bool compensated, double intervals) {
  const LinearSystem system(1.0, 0.0);
  const auto method = makeMethod("velocity_verlet");
  const double h = 0.1;
  double worst = 0.0;
  const double interval = 628.0 * h;  // outputs at grid points: the modified energy is that of whole steps
  RunOptions options = plain(h, intervals * interval);
  options.compensated = compensated;
  options.keepStates = false;
  options.outputInterval = interval;
  options.probes = {{"drift", "1", [&](const State& s) {
                       const double energy = 0.5 * (s.v[0] * s.v[0] + (1.0 - 0.25 * h * h) * s.x[0] * s.x[0]);
                       worst = std::max(worst, std::abs(energy / 0.49875 - 1.0));
                       return worst;
                     }}};
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_TRUE(run.warnings.empty());
  return worst;
}

TEST(CompensatedSums, TheModifiedEnergyOfVerletStaysOverTenThousandPeriods) {
  // The bar of H01 for 1e6 periods, 1e-11 and 1e-9, by the hundredth; the full run is on command (MUELLE_LONG_RUNS).
  EXPECT_LT(modifiedEnergyDrift(true, 1000.0), 1e-13);
  EXPECT_LT(modifiedEnergyDrift(false, 1000.0), 1e-11);
}

TEST(CompensatedSums, AMillionPeriodsWhenAskedFor) {  // 1e5 intervals of 628 steps of 0.1 s
  if (std::getenv("MUELLE_LONG_RUNS") == nullptr) GTEST_SKIP() << "set MUELLE_LONG_RUNS to run 1e6 periods (H01)";
  const double naive = modifiedEnergyDrift(false, 1e5);
  const double compensated = modifiedEnergyDrift(true, 1e5);
  std::printf("modified energy over 1e6 periods: naive %.3g, compensated %.3g\n", naive, compensated);
  EXPECT_LT(naive, 1e-9);
  EXPECT_LT(compensated, 1e-11);
}

TEST(CompensatedSums, SumsOfTinyIncrementsAreNotLost) {
  // A drift of 1e-9 m/s from x = 1 in steps of 1e-8 s: each increment is a tenth of x's last place.
  const LinearSystem system(Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Zero(1, 1), Eigen::MatrixXd::Zero(1, 1));
  for (const bool compensated : {false, true}) {
    const auto method = testing::verletWithIncrements();
    RunOptions options = plain(1e-8, 1e-4);
    options.compensated = compensated;
    options.keepStates = false;
    const RunResult run = simulate(system, *method, oscillatorAt(1.0, 1e-9), options);
    EXPECT_NEAR(run.last.x[0] - 1.0, compensated ? 1e-13 : 0.0, 3e-16);
  }
}

TEST(CompensatedSums, AMethodWithoutIncrementsSaysThatItGainsNothing) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options = plain(0.1, 1.0);
  options.compensated = true;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("increments"), std::string::npos);
  EXPECT_NEAR(run.last.x[0], std::cos(1.0), 1e-6);
}

}  // namespace
}  // namespace muelle::engine
