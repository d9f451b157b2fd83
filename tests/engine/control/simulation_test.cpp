#include "engine/control/simulation.h"

#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "support/linear_system.h"
#include "test_methods.h"
#include "test_systems.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::oscillatorAt;

/// A scene and how it is run; each stands for a kind of step.
struct SteppedCase {
  const char* name;
  const char* method;
  bool fixedStep;
  double h;
  double duration;
  double outputInterval;
};

const SteppedCase steppedCases[] = {
    {"fixed", "velocity_verlet", true, 1e-3, 0.5, 0.0},
    {"fixed, outputs between steps", "velocity_verlet", true, 1.3e-3, 0.5, 0.01},
    {"multi-step and implicit", "bdf2", true, 2e-3, 0.5, 0.007},
    {"implicit", "tr_bdf2", true, 2e-3, 0.3, 0.007},
    {"adaptive", "dormand_prince_5", false, 0.0, 0.5, 0.013},
    {"adaptive, of high order", "dop853", false, 0.0, 0.5, 0.013},
};

/// Three nodes on springs that fall on a ground with friction, bounce and slide, while a force acts for a while:
/// events, declared times, anchors. The swept bound cuts steps at the thin slab below.
std::unique_ptr<ModelSystem> eventful(double mu = 0.4) {
  Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes = {{.x = {0.0, 0.0, 0.2}, .v = {1.0, 0.0, 0.0}},
                 {.x = {0.5, 0.0, 0.3}, .v = {1.0, 0.0, 0.0}},
                 {.x = {0.2, 0.4, 0.25}, .v = {1.0, 0.0, -8.0}}};
  model.springs = {{.a = 0, .b = 1, .k = 300.0, .L0 = 0.5}, {.a = 1, .b = 2, .k = 300.0, .L0 = 0.5}};
  Obstacle ground;
  ground.material = {.k = 5e3, .mu = mu};
  Obstacle slab;
  slab.kind = Obstacle::Kind::Box;
  slab.name = "slab";
  slab.centre = {0.2, 0.4, 0.15};
  slab.halfSize = {0.05, 0.05, 1e-3};
  slab.material = {.k = 2e4};
  model.obstacles = {ground, slab};
  return build(model);
}

RunOptions optionsOf(const SteppedCase& c) {
  RunOptions options;
  options.duration = c.duration;
  options.h = c.h;
  options.fixedStep = c.fixedStep;
  options.tolerance.relative = 1e-6;
  options.outputInterval = c.outputInterval;
  options.outputTimes = {0.1234};
  return options;
}

void expectSameWork(const Work& a, const Work& b, const char* name) {
  EXPECT_EQ(a.steps, b.steps) << name;
  EXPECT_EQ(a.rejectedSteps, b.rejectedSteps) << name;
  EXPECT_EQ(a.forceEvaluations, b.forceEvaluations) << name;
  EXPECT_EQ(a.factorisations, b.factorisations) << name;
  EXPECT_EQ(a.solves, b.solves) << name;
  EXPECT_EQ(a.events, b.events) << name;
}

/// All exact: a simulation is what simulate() runs inside.
TEST(Simulation, SteppedByHandGivesTheNumbersOfSimulate) {
  for (const SteppedCase& c : steppedCases) {
    const auto system = eventful();
    RunOptions options = optionsOf(c);
    const RunResult run = simulate(*system, *makeMethod(c.method), system->initialState(), options);
    ASSERT_FALSE(run.failed()) << c.name << ": " << run.trajectory.stop.message;
    ASSERT_GT(run.work.events, 2) << c.name;
    ASSERT_GT(run.subdividedSteps, 0) << c.name;

    const auto method = makeMethod(c.method);
    Simulation simulation(*system, *method, system->initialState(), options);
    std::size_t row = 1;
    for (Advance step = simulation.advance(); step.goesOn(); step = simulation.advance()) {
      for (; row < run.trajectory.t.size() && run.trajectory.t[row] <= simulation.time(); ++row) {
        if (run.trajectory.t[row] < simulation.stepBegin()) continue;
        const State& there = simulation.at(run.trajectory.t[row]);
        EXPECT_EQ(there.x, run.trajectory.x[row]) << c.name << " at " << there.t;
        EXPECT_EQ(there.v, run.trajectory.v[row]) << c.name << " at " << there.t;
      }
    }
    EXPECT_TRUE(simulation.finished()) << c.name;
    EXPECT_FALSE(simulation.stop().stopped) << c.name;
    EXPECT_EQ(row, run.trajectory.t.size()) << c.name;
    EXPECT_EQ(simulation.state().x, run.last.x) << c.name;
    EXPECT_EQ(simulation.state().v, run.last.v) << c.name;
    EXPECT_EQ(simulation.state().z, run.last.z) << c.name;
    EXPECT_EQ(simulation.smallestStep(), run.smallestStep) << c.name;
    EXPECT_EQ(simulation.subdividedSteps(), run.subdividedSteps) << c.name;
    expectSameWork(simulation.work(), run.work, c.name);
    ASSERT_EQ(simulation.events().size(), run.events.size()) << c.name;
    for (std::size_t i = 0; i < run.events.size(); ++i) {
      EXPECT_EQ(simulation.events()[i].t, run.events[i].t) << c.name;
      EXPECT_EQ(simulation.events()[i].what, run.events[i].what) << c.name;
    }
  }
}

TEST(Simulation, IsNotChangedByALook) {
  for (const SteppedCase& c : steppedCases) {
    // With friction DOP853, which keeps a force that it has evaluated for a look, differs in the last digits.
    const double mu = std::string(c.method) == "dop853" ? 0.0 : 0.4;
    const auto system = eventful(mu);
    const auto method = makeMethod(c.method), other = makeMethod(c.method);
    const RunOptions options = optionsOf(c);
    Simulation seen(*system, *method, system->initialState(), options);
    const auto unwatched = eventful(mu);
    Simulation unseen(*unwatched, *other, unwatched->initialState(), options);
    while (seen.advance().goesOn()) {
      ASSERT_TRUE(unseen.advance().goesOn());
      for (const double part : {0.9, 0.1, 0.5}) seen.at(seen.stepBegin() + part * (seen.time() - seen.stepBegin()));
      ASSERT_EQ(seen.state().x, unseen.state().x) << c.name << " at " << seen.time();
      ASSERT_EQ(seen.state().z, unseen.state().z) << c.name << " at " << seen.time();
    }
    EXPECT_FALSE(unseen.advance().goesOn());
  }
}

/// x = cos 3t; the dense output of DOP853 has order 7, its tolerance is 1e-10: an error far below 1e-8.
TEST(Simulation, GoesToATimeAndShowsTheStateThere) {
  const LinearSystem system(3.0, 0.0);
  const auto method = makeMethod("dop853");
  StepOptions options;
  options.duration = 10.0;
  options.tolerance.relative = 1e-10;
  Simulation simulation(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_EQ(simulation.at(0.0).x[0], 1.0);
  for (int frame = 1; frame <= 60; ++frame) {
    const double t = frame / 60.0;
    ASSERT_TRUE(simulation.advanceTo(t));
    EXPECT_LE(simulation.stepBegin(), t);
    EXPECT_GE(simulation.time(), t);
    EXPECT_NEAR(simulation.at(t).x[0], std::cos(3.0 * t), 1e-8);
    EXPECT_EQ(simulation.at(t).t, t);
  }
  EXPECT_LT(simulation.work().steps, 60) << "no step ends for a frame";
  EXPECT_THROW(simulation.at(simulation.time() + 1e-3), std::out_of_range);
  EXPECT_THROW(simulation.at(0.0), std::out_of_range);
  EXPECT_FALSE(simulation.advanceTo(11.0));
  EXPECT_EQ(simulation.time(), 10.0);
  EXPECT_EQ(simulation.advance().kind, Advance::Kind::Finished);
  EXPECT_NEAR(simulation.state().x[0], std::cos(30.0), 1e-8);
}

/// What a step has done: its length, and what lies at its end.
TEST(Simulation, SaysWhatHappened) {
  const testing::PulsedMass system([](double, int segment) { return segment == 1 ? 1.0 : 0.0; }, {0.25});
  const auto method = testing::classicalRungeKutta();
  StepOptions options;
  options.h = 0.1;
  options.duration = 0.4;
  options.outputTimes = {0.1};
  Simulation simulation(system, *method, oscillatorAt(0.0, 0.0), options);
  std::vector<double> ends;
  std::string seen;
  for (Advance step = simulation.advance(); step.goesOn(); step = simulation.advance()) {
    ends.push_back(simulation.time());
    EXPECT_NEAR(step.length, simulation.time() - simulation.stepBegin(), 1e-15);
    seen += step.atOutput ? 'o' : '-';
    seen += step.hasJumped ? 'j' : '-';
    seen += ' ';
  }
  EXPECT_EQ(ends, (std::vector<double>{0.1, 0.2, 0.25, 3 * 0.1, 0.4}));
  EXPECT_EQ(seen, "o- -- -j -- o- ");
  ASSERT_EQ(simulation.events().size(), 1U);
  EXPECT_EQ(simulation.events()[0].what, "declared time");
  // After 0.25 s the unit force: x = (t - 0.25)^2 / 2, exact for Runge-Kutta but for rounding.
  EXPECT_NEAR(simulation.state().x[0], 0.5 * 0.15 * 0.15, 1e-15);
}

/// A multi-step method that went on with states of another motion would differ at once; a fresh one is the oracle.
TEST(Simulation, ForgetsEarlierStepsWhenANodeIsPulled) {
  const LinearSystem system(3.0, 0.2);
  for (const char* id : {"bdf2", "tr_bdf2", "velocity_verlet", "dop853"}) {
    const auto method = makeMethod(id), fresh = makeMethod(id);
    StepOptions options;
    options.fixedStep = true;
    options.h = 1.0 / 64.0;  // a power of 2, so that both grids are the same numbers
    options.duration = 1.0;
    Simulation pulled(system, *method, oscillatorAt(1.0, 0.0), options);
    ASSERT_TRUE(pulled.advanceTo(0.5));
    State elsewhere = pulled.state();
    elsewhere.x[0] = -2.0;
    elsewhere.v[0] = 0.25;
    pulled.setState(elsewhere);
    EXPECT_EQ(pulled.stepBegin(), 0.5) << "there is no step to look into";
    EXPECT_EQ(pulled.state().x[0], -2.0);

    options.duration = 0.5;
    Simulation anew(system, *fresh, elsewhere, options);
    while (anew.advance().goesOn()) {
      ASSERT_TRUE(pulled.advance().goesOn());
      EXPECT_EQ(pulled.state().x, anew.state().x) << id << " at " << anew.time();
      EXPECT_EQ(pulled.state().v, anew.state().v) << id << " at " << anew.time();
    }
    EXPECT_EQ(pulled.work().steps, 64) << id;
  }
}

/// The system of a player whose spring is replaced by a stiffer one: what a method has kept is of the old one. A fresh
/// simulation of the new one is the oracle, to the last bit.
TEST(Simulation, GoesOnWithASystemThatHasChanged) {
  struct Changing final : DynamicalSystem, Linearisation {
    double k = 9.0;
    double m = 1.0;
    int size() const override { return 1; }
    std::span<const double> mass() const override { return {&m, 1}; }
    void force(double, In x, In, In, Out f) const override { f[0] = -k * x[0]; }
    const Linearisation* linearisation() const override { return this; }
    void assemble(double cM, double, double cK, double, In, In, In, Form, SystemMatrix& J) const override {
      J.sparse.resize(1, 1);
      J.sparse.coeffRef(0, 0) = cM * m + cK * k;
      J.sparse.makeCompressed();
    }
  } system;
  for (const char* id : {"bdf2", "tr_bdf2", "velocity_verlet", "dormand_prince_5", "dop853"}) {
    system.k = 9.0;
    const auto method = makeMethod(id), fresh = makeMethod(id);
    StepOptions options;
    options.fixedStep = true;
    options.h = 1.0 / 64.0;  // a power of 2, so that both grids are the same numbers
    options.duration = 1.0;
    Simulation simulation(system, *method, oscillatorAt(1.0, 0.0), options);
    ASSERT_TRUE(simulation.advanceTo(0.5));
    const State there = simulation.state();
    const Work before = simulation.work();
    system.k = 90.0;
    simulation.restart();
    EXPECT_EQ(simulation.state().x, there.x);
    EXPECT_GE(simulation.work().forceEvaluations, before.forceEvaluations);

    options.duration = 0.5;
    Simulation anew(system, *fresh, there, options);
    while (anew.advance().goesOn()) {
      ASSERT_TRUE(simulation.advance().goesOn());
      EXPECT_EQ(simulation.state().x, anew.state().x) << id << " at " << anew.time();
    }
    EXPECT_EQ(simulation.work().steps, 64) << id;
  }
}

/// A node that a player puts onto the other side of a guard has its modes decided anew: put into the ground it is
/// pushed out, and leaves at the speed that the contact's energy gives it: m v^2 / 2 = k x^2 / 2 - m g x.
TEST(Simulation, DecidesModesAnewWhereANodeIsPut) {
  const testing::PenaltyBalls system(1, 1e4, 0.0, 10.0);
  const auto method = makeMethod("dop853");
  StepOptions options;
  options.duration = 1.0;
  options.tolerance.relative = 1e-10;
  options.outputTimes = {0.1};
  Simulation simulation(system, *method, oscillatorAt(5.0, 0.0), options);
  while (simulation.time() < 0.1) ASSERT_TRUE(simulation.advance().goesOn());
  State deep = simulation.state();
  deep.x[0] = -0.1;
  deep.v[0] = 0.0;
  simulation.setState(deep);
  while (simulation.events().empty()) ASSERT_TRUE(simulation.advance().goesOn());
  EXPECT_NEAR(simulation.state().x[0], 0.0, 1e-12);
  EXPECT_NEAR(simulation.state().v[0], std::sqrt(1e4 * 0.01 - 2.0 * 10.0 * 0.1), 1e-6);
}

TEST(Simulation, KeepsTheLastGoodStateAndCanBeSetGoingAgain) {
  struct Wall final : DynamicalSystem {
    double m = 1.0;
    int size() const override { return 1; }
    std::span<const double> mass() const override { return {&m, 1}; }
    void force(double, In x, In, In, Out f) const override {
      f[0] = x[0] > 0.5 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    }
  } system;
  const auto method = testing::classicalRungeKutta();
  StepOptions options;
  options.h = 0.1;
  options.duration = 2.0;
  Simulation simulation(system, *method, oscillatorAt(0.0, 1.0), options);
  while (simulation.advance().goesOn()) EXPECT_TRUE(std::isfinite(simulation.state().x[0]));
  EXPECT_TRUE(simulation.stop().stopped);
  EXPECT_NE(simulation.stop().message.find("not finite"), std::string::npos) << simulation.stop().message;
  EXPECT_LE(simulation.state().x[0], 0.5 + 1e-12);
  const double stopped = simulation.time();
  EXPECT_EQ(simulation.advance().kind, Advance::Kind::Stopped);
  EXPECT_EQ(simulation.time(), stopped);

  simulation.setState({stopped, {0.0}, {-1.0}, {}});
  EXPECT_FALSE(simulation.stop().stopped);
  while (simulation.advance().goesOn()) continue;
  EXPECT_TRUE(simulation.finished());
  EXPECT_NEAR(simulation.state().x[0], -(2.0 - stopped), 1e-12);
}

TEST(Simulation, RefusesAStateOfAnotherTimeOrSizeOrNone) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  StepOptions options;
  options.h = 0.1;
  Simulation simulation(system, *method, oscillatorAt(1.0, 0.0), options);
  simulation.advance();
  EXPECT_THROW(simulation.setState({0.0, {1.0}, {0.0}, {}}), std::invalid_argument);
  EXPECT_THROW(simulation.setState({0.1, {1.0, 2.0}, {0.0}, {}}), std::invalid_argument);
  EXPECT_THROW(simulation.setState({0.1, {std::numeric_limits<double>::infinity()}, {0.0}, {}}), std::invalid_argument);
  EXPECT_THROW(Simulation(system, *method, oscillatorAt(1.0, 0.0), StepOptions{}), std::invalid_argument)
      << "no step is given";
}

TEST(Simulation, LendsItsMethodAndGoesOnAsIfItHadNot) {
  const LinearSystem system(3.0, 0.0), stranger(50.0, 1.0);
  const auto method = makeMethod("velocity_verlet"), alone = makeMethod("velocity_verlet");
  StepOptions options;
  options.h = 0.01;
  options.duration = 0.2;
  Simulation lender(system, *method, oscillatorAt(1.0, 0.0), options);
  Simulation other(system, *alone, oscillatorAt(1.0, 0.0), options);
  while (lender.advance().goesOn()) {
    ASSERT_TRUE(other.advance().goesOn());
    const Work before = lender.work();
    lender.lendMethod([&](Integrator& lent) {
      RunOptions run;
      run.h = 0.01;
      run.duration = 0.1;
      simulate(stranger, lent, oscillatorAt(1.0, 0.0), run);
    });
    EXPECT_EQ(lender.work().forceEvaluations, before.forceEvaluations);
    EXPECT_EQ(lender.state().x, other.state().x);
  }
}

}  // namespace
}  // namespace muelle::engine
