#include "engine/control/simulate.h"
#include "engine/integrators/implicit/methods.h"
#include "engine/model/model_system.h"
#include "run.h"
#include "support/linear_system.h"
#include "support/spring_network.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::run;
using testing::SpringNetwork;
using testing::start;
using Vector = Eigen::VectorXd;

using Make = std::unique_ptr<Integrator> (*)();
constexpr Make methods[] = {backwardEuler,    linearisedBackwardEuler, bdf2, trBdf2, esdirk4,
                            implicitMidpoint, discreteGradient};

/// A force alone: no energy, no derivatives.
class Bare : public DynamicalSystem {
 public:
  int size() const override { return 1; }
  std::span<const double> mass() const override { return mass_; }
  void force(double, In x, In, In, Out f) const override { f[0] = -x[0]; }

 private:
  std::vector<double> mass_ = {1.0};
};

TEST(Failure, NamesTheMethodAndWhatTheSystemLacks) {
  for (const Make make : methods) {
    const auto method = make();
    try {
      method->prepare(Bare(), {});
      ADD_FAILURE() << method->info().id;
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(method->info().id), std::string::npos) << text;
      EXPECT_NE(text.find("linearisation"), std::string::npos) << text;
    }
  }
}

TEST(Failure, OfNumbersThatAreNotFiniteIsReportedInTheSameStep) {
  const LinearSystem system(Vector::Ones(2), Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Zero(2, 2));
  for (const Make make : methods) {
    const auto method = make();
    method->prepare(system, {});
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      State from = start({1.0, bad}, {0.0, 0.0}), to = from;
      const StepResult result = method->step(system, from, 0.1, to);
      EXPECT_FALSE(result.done) << method->info().id;
      EXPECT_NE(result.failure.find("finite"), std::string::npos) << result.failure;
      EXPECT_NE(result.failure.find(method->info().id), std::string::npos) << result.failure;
    }
  }
}

/// A force without potential whose derivatives are not symmetric: x' turns in a plane and is damped. No line search on
/// an energy can help; the exact Jacobian does.
class Turning : public DynamicalSystem, public Linearisation {
 public:
  int size() const override { return 2; }
  std::span<const double> mass() const override { return mass_; }
  const Linearisation* linearisation() const override { return this; }
  void force(double, In x, In v, In, Out f) const override {
    const double r = x[0] * x[0] + x[1] * x[1];
    f[0] = -4.0 * x[0] - 30.0 * x[1] * r - 2.0 * v[0];
    f[1] = -4.0 * x[1] + 30.0 * x[0] * r - 2.0 * v[1];
  }
  void assemble(double cM, double cD, double cK, double, In x, In, In, Form, SystemMatrix& J) const override {
    const double r = x[0] * x[0] + x[1] * x[1], a = x[0], b = x[1];
    Eigen::Matrix2d K;
    K << 4.0 + 60.0 * a * b, 30.0 * (r + 2.0 * b * b), -30.0 * (r + 2.0 * a * a), 4.0 - 60.0 * a * b;
    const Eigen::Matrix2d sum = (cM + 2.0 * cD) * Eigen::Matrix2d::Identity() + cK * K;
    J.sparse = Eigen::MatrixXd(sum).sparseView();
    J.sparse.makeCompressed();
    J.symmetric = false;
  }

 private:
  std::vector<double> mass_ = {1.0, 1.0};
};

TEST(NonSymmetricJacobian, IsUsedWhereThereIsNoPotential) {
  const Turning system;
  for (const Make make : {backwardEuler, bdf2, implicitMidpoint}) {
    const auto method = make();
    method->prepare(system, {});
    State from = start({1.0, 0.2}, {0.0, 0.5}), to = from;
    for (int i = 0; i < 20; ++i) {
      ASSERT_TRUE(method->step(system, from, 0.05, to).done) << method->info().id;
      method->accept();
      std::swap(from, to);
    }
    // Quadratic convergence: few iterations a step (two stages in the first step of BDF2).
    EXPECT_LE(method->work().newtonIterations, 20 * 7) << method->info().id;
  }
  // The equation of backward Euler itself.
  State from = start({1.0, 0.2}, {0.0, 0.5}), to = run(system, *backwardEuler(), from, 0.05, 1);
  double f[2];
  system.force(0.05, to.x, to.v, {}, f);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(to.v[i], from.v[i] + 0.05 * f[i], 1e-13);
    EXPECT_NEAR(to.x[i], from.x[i] + 0.05 * to.v[i], 1e-15);
  }
}

/// A discrete gradient whose equation M w = h F has no solution for any step: F = (w + 1) / h.
class Unsolvable : public DynamicalSystem, public Linearisation, public Potential {
 public:
  double h = 0.1;
  int size() const override { return 1; }
  std::span<const double> mass() const override { return mass_; }
  void force(double, In, In, In, Out f) const override { f[0] = 0.0; }
  const Linearisation* linearisation() const override { return this; }
  const Potential* potential() const override { return this; }
  void assemble(double cM, double, double, double, In, In, In, Form, SystemMatrix& J) const override {
    J.sparse = Eigen::MatrixXd::Constant(1, 1, cM).sparseView();
    J.sparse.makeCompressed();
  }
  bool isComplete() const override { return true; }
  double energy(double, In, In) const override { return 0.0; }
  void conservativeForce(double, In, In, Out f) const override { f[0] = 0.0; }
  void discreteGradientForce(double, In xa, In xb, In, Out f) const override {
    f[0] = (2.0 * (xb[0] - xa[0]) / h + 1.0) / h;  // at rest: xb - xa = h w / 2
  }

 private:
  std::vector<double> mass_ = {1.0};
};

/// The attempts at one step, each half as long as the last, spend 50 Newton steps at most, and the last one says so.
TEST(DiscreteGradient, GivesUpAStepWithinFiftyNewtonStepsHalvingsIncluded) {
  Unsolvable system;
  const auto method = discreteGradient();
  method->prepare(system, {});
  const State from = start({0.0});
  State to = from;
  StepResult result;
  int attempts = 0;
  do {
    result = method->step(system, from, system.h, to);
    ASSERT_FALSE(result.done);
    system.h *= 0.5;
    ++attempts;
  } while (result.retry && attempts < 100);
  EXPECT_FALSE(result.retry);
  EXPECT_LE(method->work().newtonIterations, 50);
  EXPECT_NE(result.failure.find("halvings included"), std::string::npos) << result.failure;
  EXPECT_NE(result.failure.find("residual"), std::string::npos) << result.failure;
  // Another step has its own.
  State later = from;
  later.t = 1.0;
  EXPECT_TRUE(method->step(system, later, system.h, to).retry);
}

/// A discrete gradient that pushes back to where the step began: M w = h F has no solution for any h.
class PushesBack : public Unsolvable {
 public:
  void discreteGradientForce(double, In xa, In xb, In, Out f) const override { f[0] = xb[0] > xa[0] ? -1.0 : 1.0; }
};

TEST(DiscreteGradient, EndsARunWithTheReason) {
  const PushesBack system;
  RunOptions options;
  options.duration = 1.0;
  options.h = 0.1;
  options.checkStability = options.checkNumericalDamping = false;
  const auto method = discreteGradient();
  const RunResult result = simulate(system, *method, start({0.0}), options);
  EXPECT_TRUE(result.failed());
  EXPECT_EQ(result.last.t, 0.0);
  EXPECT_LE(result.work.newtonIterations, 50);
  EXPECT_NE(result.trajectory.stop.message.find("Newton"), std::string::npos) << result.trajectory.stop.message;
}

/// One Newton step is not the solution: the error of Baraff-Witkin's step in its own equation is of second order.
TEST(LinearisedBackwardEuler, LeavesAResidualOfSecondOrder) {
  const SpringNetwork system(2, {1.0}, {{.k = 100.0, .L0 = 1.0}}, Vector{{0.0, -9.81}});
  double residual[2];
  for (int i = 0; i < 2; ++i) {
    const double h = 0.02 / (1 << i);
    const State from = start({0.3, -1.1}, {2.0, 0.0}), to = run(system, *linearisedBackwardEuler(), from, h, 1);
    double f[2];
    system.force(h, to.x, to.v, {}, f);
    residual[i] = std::hypot(to.v[0] - from.v[0] - h * f[0], to.v[1] - from.v[1] - h * f[1]) / h;
  }
  EXPECT_GT(residual[1], 1e-3);
  EXPECT_NEAR(std::log2(residual[0] / residual[1]), 2.0, 0.2);
}

/// Reference case H05: a property of rank one among many nodes. All move alike, as one oscillator of omega = 20, so
/// that the midpoint rule's phase is known.
TEST(Property, MovesAllNodesAsTheDiscreteOscillator) {
  Model model;
  ModelProperty mean;
  mean.k = 400.0;
  mean.p0 = 1.0;
  for (int i = 0; i < 1000; ++i) {
    ModelNode node;
    node.x = {0.0, 0.0, i / 1000.0};
    node.m = 0.001;
    model.nodes.push_back(node);
    mean.nodes.push_back(i);
    mean.weights.push_back({0.0, 0.0, 0.001});
  }
  model.properties = {mean};
  const auto system = build(model);
  const State end = run(*system, *implicitMidpoint(), system->initialState(), 0.01, 100);
  double height = 0.0;
  for (int i = 0; i < 1000; ++i) height += 0.001 * system->position(end, i)[2];
  const double angle = 100.0 * 2.0 * std::atan(0.5 * 20.0 * 0.01);
  EXPECT_NEAR(height, 1.0 - 0.5005 * std::cos(angle), 1e-12);
}

}  // namespace
}  // namespace muelle::engine
