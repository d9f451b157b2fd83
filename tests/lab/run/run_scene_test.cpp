#include "lab/run/run_scene.h"
#include "lab/run/energy_balance.h"
#include "lab/run/error_estimate.h"
#include "lab/run/scene_figures.h"
#include "support/scene_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>
#include <numbers>

namespace muelle::lab {

using namespace engine;
namespace {

using ::testing::HasSubstr;

Scene oscillator() {
  return sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\n" +
                   "[[output]]\nkind = 'position'\nname = 'position of the mass'\nnodes = [1]\naxis = 'x'\n" + run);
}

/// x(t) = 1 + 0.2 cos(10 t).
double exactPosition(double t) { return 1.0 + 0.2 * std::cos(10.0 * t); }

TEST(Run, FollowsTheOscillator) {
  Scene scene = oscillator();
  scene.method = "dop853";
  scene.tolerance = 1e-11;
  const SceneRun result = runScene(scene);
  EXPECT_FALSE(result.result.failed());
  EXPECT_DOUBLE_EQ(result.result.last.t, 1.0);
  EXPECT_NEAR(result.result.last.x[0], exactPosition(1.0), 1e-10);
  EXPECT_NEAR(result.result.trajectory.track("position of the mass").back(), exactPosition(1.0), 1e-10);
  EXPECT_NEAR(result.result.trajectory.track("total energy").front(), 2.0, 1e-14);
  const EnergyBalance& balance = result.energy;
  EXPECT_EQ(balance.fate, EnergyFate::Kept);
  EXPECT_LT(balance.highest - balance.lowest, 1e-9);
  // Elastic energy 100 (0.2)^2 / 2 = 2 J, and a force of 20 N along the extent of 1.2 m.
  EXPECT_NEAR(balance.scale, 26.0, 1e-12);
}

TEST(ErrorEstimate, StepHalvingFindsTheTrueErrorOfVelocityVerlet) {
  const Scene scene = oscillator();
  const SceneRun result = runScene(scene);
  const Trajectory& path = result.result.trajectory;
  double off = 0.0;
  for (std::size_t i = 0; i < path.t.size(); ++i)
    off = std::max(off, std::abs(path.x[i][0] - exactPosition(path.t[i])));
  const double trueError = off / 0.4;  // from 1.2 m to 0.8 m and back
  const ErrorEstimate estimate = estimateError(scene, result);
  EXPECT_TRUE(estimate.failure.empty());
  EXPECT_EQ(estimate.how, "step halved, order 2 seen");
  // Richardson leaves the next term of the series, h^4: (h omega)^2 = 0.01 of the error here.
  EXPECT_NEAR(estimate.position, trueError, 0.02 * trueError);
  ASSERT_EQ(estimate.outputs.size(), 1U);
  EXPECT_NEAR(estimate.outputs[0].value, trueError, 0.02 * trueError);
  EXPECT_GT(trueError, 1e-3);
}

TEST(ErrorEstimate, OfAnAdaptiveMethodBoundsTheTrueError) {
  Scene scene = oscillator();
  scene.method = "dormand_prince_5";
  scene.tolerance = 1e-7;
  const SceneRun result = runScene(scene);
  const Trajectory& path = result.result.trajectory;
  double off = 0.0;
  for (std::size_t i = 0; i < path.t.size(); ++i)
    off = std::max(off, std::abs(path.x[i][0] - exactPosition(path.t[i])));
  const double trueError = off / 0.4;
  const double estimate = estimateError(scene, result).position;
  EXPECT_GT(estimate, 0.5 * trueError);
  EXPECT_LT(estimate, 2.0 * trueError + 1e-14);
}

/// Where an anchor moves at u = 0.8 m/s and stops at T, the mass swings about it: y = x - anchor - L0 begins with the
/// speed -u, and gains u at T. (omega = 10 / s.)
double behindAnAnchorThatStops(double t, double T) {
  constexpr double omega = 10.0, u = 0.8, L0 = 1.0;
  const double y = -u / omega * std::sin(omega * T);
  const double speed = u - u * std::cos(omega * T);
  return u * T + L0 + y * std::cos(omega * (t - T)) + speed / omega * std::sin(omega * (t - T));
}

/// Seen on adaptive explicit methods in a contact, where a tenth of the tolerance is beyond rounding: here the first
/// run says that it was far shorter than it was.
TEST(ErrorEstimate, GivesUpOnAFinerRunThatTakesFarMoreThanTheFirst) {
  Scene scene = oscillator();
  scene.step = 5e-5;
  SceneRun result = runScene(scene);
  EXPECT_EQ(estimateError(scene, result).failure, "");
  result.result.work.forceEvaluations = 1;
  EXPECT_EQ(estimateError(scene, result).failure,
            "the finer run would take more than 20,040 force evaluations, and the first took 1");
}

TEST(Motion, KeepsTheOrderOfAMethodWhereItEnds) {
  const double T = 0.73, end = 1.5;
  Scene scene = sceneFrom(head + "[[node]]\nx = 0.0\nm = 1.0\n[[node]]\nx = 1.0\nm = 1.0\n" +
                          "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1.0\n" +
                          "[[motion]]\nnodes = [0]\nvelocity = 0.8\nduring = [0.0, 0.73]\n" + run);
  scene.method = "kahan_li_8";
  scene.duration = end;
  const auto error = [&](double h) {
    scene.step = h;
    return std::abs(runScene(scene).result.last.x[0] - behindAnAnchorThatStops(end, T));
  };
  const double coarse = error(0.05);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_LT(error(0.025), coarse / std::pow(2.0, 7.0));  // of order 8, a step short of it for the cut at T
}

TEST(Force, ThatHumsIsNotSteppedOver) {
  Scene scene = sceneFrom(head + "[[node]]\nx = 1.0\nm = 1.0\n[[node]]\nx = 0.0\npinned = true\n" +
                          "[[spring]]\nnodes = [0, 1]\nk = 4.0\nL0 = 1.0\n" +
                          "[[force]]\nnodes = [0]\nF = 100.0\nfrequency = 50.0\n" + run);
  scene.method = "dop853";
  scene.tolerance = 1e-2;
  scene.duration = 2.0;
  constexpr double omega = 2.0, drive = 100.0 * std::numbers::pi, F = 100.0;
  const double amplitude = F / (omega * omega - drive * drive);
  const double t = scene.duration;
  const double exact = 1.0 + amplitude * (std::sin(drive * t) - drive / omega * std::sin(omega * t));
  const SceneRun result = runScene(scene);
  EXPECT_GE(result.result.work.steps, 8 * 100);  // eight a period
  EXPECT_NEAR(result.result.last.x[0], exact, 1e-2 * std::abs(amplitude * drive / omega));
}

TEST(Overrides, ReplaceMethodStepAndDuration) {
  RunOverrides overrides;
  overrides.method = "symplectic-euler";
  overrides.step = 0.002;
  overrides.duration = 0.5;
  overrides.events = false;
  const Scene scene = applied(oscillator(), overrides);
  EXPECT_EQ(scene.method, "symplectic_euler");
  const RunOptions options = optionsOf(scene);
  EXPECT_TRUE(options.fixedStep);
  EXPECT_EQ(options.h, 0.002);
  EXPECT_EQ(options.duration, 0.5);
  EXPECT_FALSE(options.locateEvents);
  EXPECT_EQ(runScene(scene).result.work.steps, 250);
}

TEST(Overrides, AnAdaptiveMethodChoosesItsStepsUnlessAStepIsGiven) {
  RunOverrides overrides;
  overrides.method = "dop853";
  EXPECT_FALSE(optionsOf(applied(oscillator(), overrides)).fixedStep);
  overrides.tolerance = 1e-9;
  EXPECT_EQ(optionsOf(applied(oscillator(), overrides)).tolerance.relative, 1e-9);
  overrides.tolerance.reset();
  overrides.step = 0.05;
  EXPECT_TRUE(optionsOf(applied(oscillator(), overrides)).fixedStep);
  EXPECT_EQ(optionsOf(applied(oscillator(), overrides)).h, 0.05);
}

std::string complaintAboutOverrides(const RunOverrides& overrides) {
  try {
    applied(oscillator(), overrides);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Overrides, SayWhichOptionIsWrong) {
  RunOverrides overrides;
  overrides.tolerance = 1e-6;
  EXPECT_EQ(complaintAboutOverrides(overrides), "--tolerance: velocity_verlet has no error estimate; give --step");
  overrides.tolerance.reset();
  for (const double step : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    overrides.step = step;
    EXPECT_THAT(complaintAboutOverrides(overrides), HasSubstr("--step is ")) << step;
  }
  overrides.step.reset();
  overrides.duration = -1.0;
  EXPECT_EQ(complaintAboutOverrides(overrides), "--duration is -1 s; it must be positive and finite");
  overrides.duration.reset();
  overrides.method = "velocity_verlt";
  EXPECT_EQ(complaintAboutOverrides(overrides), "no method 'velocity_verlt'; did you mean 'velocity_verlet'?");
}

TEST(Summary, NamesMethodErrorEnergyAndWork) {
  const Scene scene = oscillator();
  SceneRun result = runScene(scene);
  result.error = estimateError(scene, result);
  const std::string text = summaryOf(scene, result);
  EXPECT_THAT(text, HasSubstr("test: A test"));
  EXPECT_THAT(text, HasSubstr("2 nodes, 1 spring, 1 unknown"));
  EXPECT_THAT(text, HasSubstr("velocity Verlet, order 2"));
  EXPECT_THAT(text, HasSubstr("h = 0.01 s, 100 steps"));
  EXPECT_THAT(text, HasSubstr("step halved, order 2 seen; "));
  EXPECT_THAT(text, HasSubstr("2 J at the start"));
  EXPECT_THAT(text, HasSubstr("101 force evaluations"));
}

TEST(Summary, SaysWhereSinglePrecisionIsAndWhereItChangesNothing) {
  Scene net = oscillator();
  net.model = {};
  net.model.precision = kernels::Precision::Single;
  net.outputs.clear();
  for (int i = 0; i < 36; ++i) {
    net.model.nodes.push_back({.x = {0.1 * (i % 6), 0.1 * (i / 6), 0.0}, .v = {0.0, 0.0, 0.01 * i}, .pinned = i < 6});
    if (i % 6 > 0) net.model.springs.push_back({.a = i - 1, .b = i, .k = 10.0, .L0 = 0.09});
    if (i >= 6) net.model.springs.push_back({.a = i - 6, .b = i, .k = 10.0, .L0 = 0.09});
    if (i % 6 > 0 && i >= 6) net.model.springs.push_back({.a = i - 7, .b = i, .k = 10.0, .L0 = 0.14});
  }
  EXPECT_THAT(summaryOf(net, runScene(net)), HasSubstr("velocity Verlet, order 2, springs in single precision"));
  net.method = "implicit_midpoint";
  EXPECT_THAT(summaryOf(net, runScene(net)),
              HasSubstr("\"single\" changes nothing: implicit midpoint balances forces in "
                        "double"));
  Scene none = oscillator();
  none.model.precision = kernels::Precision::Single;
  EXPECT_THAT(summaryOf(none, runScene(none)), HasSubstr("\"single\" changes nothing: no springs lie on a grid"));
}

/// "1e+02 %" is no number that one reads.
TEST(Summary, CountsEnergiesBeyondTheScaleInTimes) {
  Scene scene = oscillator();
  SceneRun result = runScene(scene);
  result.energy.scale = 2.0;
  result.energy.highest = 0.0;
  for (const auto& [lost, said] :
       {std::pair(1.98, "(up to 99 % of the scene's 2 J)"), std::pair(1.999, "(up to 1 times the scene's 2 J)"),
        std::pair(2.6, "(up to 1.3 times the scene's 2 J)")}) {
    result.energy.lowest = -lost;
    EXPECT_THAT(summaryOf(scene, result), HasSubstr(said));
  }
}

/// On an oscillator linear theory is all there is: backward Euler keeps (1 + (h w)^2)^-n of the energy, w = 10 /s.
TEST(Summary, SetsTheLossOfAnImplicitMethodBesideThatOfItsStabilityFunction) {
  Scene scene = oscillator();
  scene.method = "backward_euler";
  SceneRun result = runScene(scene);
  const double kept = std::pow(1.01, -100.0);
  ASSERT_TRUE(result.energy.linearLoss.has_value());
  EXPECT_NEAR(result.energy.linearLoss->share, 1.0 - kept, 1e-9);
  EXPECT_NEAR(result.energy.linearLoss->fastest, 0.1, 1e-9);
  EXPECT_NEAR(result.energy.linearLoss->factor, 1.0 / std::sqrt(1.01), 1e-9);
  EXPECT_NEAR(-result.energy.end, 2.0 * (1.0 - kept), 1e-7);
  EXPECT_THAT(summaryOf(scene, result), HasSubstr("1.26 J by the method, 4.8 % of the scene's 26 J; its stability "
                                                  "function takes 63 % of the modes that hold energy at the start"));
  for (const char* id : {"velocity_verlet", "implicit_midpoint"}) {  // keep it
    scene.method = id;
    EXPECT_FALSE(runScene(scene).energy.linearLoss.has_value()) << id;
  }
}

TEST(Failure, OfARunIsReportedAndLeavesNoEstimate) {
  Scene scene = oscillator();
  scene.step = 0.3;  // h omega = 3
  scene.duration = 100.0;
  const SceneRun result = runScene(scene);
  ASSERT_TRUE(result.result.failed());
  EXPECT_FALSE(result.result.trajectory.stop.message.empty());
  EXPECT_EQ(estimateError(scene, result).failure, "the run did not reach its end");
}

TEST(Table, HasTheNodesAsTheSceneNumbersThem) {
  const Scene scene = readScene(MUELLE_SCENES "/hanging_chain.toml");
  RunOverrides overrides;
  overrides.duration = 0.02;
  const SceneRun result = runScene(applied(scene, overrides));
  const Trajectory table = trajectoryOf(result);
  EXPECT_EQ(axesOf(scene.model), "xz");
  ASSERT_EQ(table.x.front().size(), 2u * 21u);
  for (int node = 0; node < 21; ++node) {
    EXPECT_EQ(table.x.front()[static_cast<std::size_t>(2 * node)],
              scene.model.nodes[static_cast<std::size_t>(node)].x[0]);
    EXPECT_EQ(table.x.front()[static_cast<std::size_t>(2 * node + 1)],
              scene.model.nodes[static_cast<std::size_t>(node)].x[2]);
  }
  EXPECT_EQ(table.x.back().front(), 0.0);  // a hook
}

TEST(Rods, OfAGeneratorAreThoseOfSpringTablesBitForBit) {
  const std::string begin = "title = 'A'\nshows = 'b'\nslide = 'c'\ndimension = 2\ngravity = 9.81\n";
  const std::string end = "[run]\nmethod = 'rattle'\nstep = 0.01\nduration = 1.0\n";
  const std::string chain =
      "[[object]]\nkind = 'chain'\nnodes = 5\nfrom = [0, 0]\nto = [4, 0]\nrod = true\nmass = 5\n"
      "[[pin]]\nnodes = [0]\n";
  std::string tables;
  for (int i = 0; i < 5; ++i) {
    tables += fmt::format("[[node]]\nx = [{}, 0]\nm = 1\npinned = {}\n", i, i == 0 ? "true" : "false");
  }
  for (int i = 0; i < 4; ++i) tables += fmt::format("[[spring]]\nnodes = [{}, {}]\nrod = true\n", i, i + 1);
  const SceneRun generated = runScene(sceneFrom(begin + chain + end));
  const SceneRun byHand = runScene(sceneFrom(begin + tables + end));
  ASSERT_FALSE(generated.result.failed());
  EXPECT_LT(generated.system->position(generated.result.last, 4)[2], -0.5) << "it falls";
  EXPECT_EQ(generated.result.trajectory.x, byHand.result.trajectory.x);
  EXPECT_EQ(generated.result.trajectory.v, byHand.result.trajectory.v);
}

TEST(Rods, OfAGridAreRedundantAndNamed) {
  const std::string grid =
      "title = 'A'\nshows = 'b'\nslide = 'c'\ndimension = 2\n[[object]]\nkind = 'grid'\nnodes = [2, 2]\n"
      "spacing = 1\nrod = true\nmass = 1\n[[pin]]\nnodes = [0, 1]\n[run]\nmethod = 'rattle'\nstep = 0.01\n"
      "duration = 1.0\n";
  try {
    runScene(sceneFrom(grid));
    FAIL() << "both ends of the first rod are pinned";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("redundant rod"));
  }
}

TEST(Figures, AreThoseOfTheOutputs) {
  const Scene scene = readScene(MUELLE_SCENES "/elastic_pendulum.toml");
  const std::vector<Figure> figures = figuresOf(scene, runScene(scene));
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.id());
  EXPECT_THAT(names, ::testing::ElementsAre("elastic_pendulum_energy", "elastic_pendulum_outputs",
                                            "elastic_pendulum_shape", "elastic_pendulum_path"));
}

TEST(Figures, TellThePotentialEnergyFromItsLeast) {
  const Scene scene = readScene(MUELLE_SCENES "/elastic_pendulum.toml");  // it hangs 10 J below its hook
  const Figure energy = figuresOf(scene, runScene(scene)).front();
  const std::vector<Series>& curves = energy.panels().front().series;
  ASSERT_EQ(curves[1].name, "potential");
  EXPECT_EQ(*std::ranges::min_element(curves[1].y), 0.0);
  for (std::size_t i = 0; i < curves[0].y.size(); ++i) {
    // Three sums of numbers of about 10 J, each rounded to 2e-15 J.
    EXPECT_NEAR(curves[0].y[i] + curves[1].y[i], curves[2].y[i], 1e-14);
  }
  EXPECT_FALSE(energy.panels().front().yExpected) << "nothing to cut in a run that went well";
}

TEST(Figures, MarkNodesAndTheStartsOfPaths) {
  const Scene scene = readScene(MUELLE_SCENES "/elastic_pendulum.toml");
  const std::vector<Figure> figures = figuresOf(scene, runScene(scene));
  const auto& shape = figures[2].panels().front().series;
  const auto nodes = std::ranges::find(shape, "nodes", &Series::name);
  ASSERT_NE(nodes, shape.end());
  EXPECT_EQ(nodes->x.size(), scene.model.nodes.size());
  const auto& path = figures[3].panels().front().series;
  const auto start = std::ranges::find(path, "start", &Series::name);
  ASSERT_NE(start, path.end());
  EXPECT_EQ(start->x, std::vector<double>{path.front().x.front()});
  EXPECT_EQ(start->y, std::vector<double>{path.front().y.front()});
}

TEST(Figures, ShowWhatCameBeforeAnExplosion) {
  RunOverrides overrides;
  overrides.method = "explicit_euler";
  overrides.step = 0.2;
  overrides.duration = 20.0;
  const Scene scene = applied(oscillator(), overrides);
  const SceneRun run = runScene(scene);
  ASSERT_TRUE(run.result.failed());
  for (const Figure& figure : figuresOf(scene, run)) {
    const Panel& panel = figure.panels().front();
    ASSERT_TRUE(panel.yExpected) << figure.id();
    // Energies end at 1e9 J, positions at 1e4 m.
    EXPECT_LT(panel.yExpected->second, 200.0) << figure.id();
  }
}

TEST(Figures, TakeATitleInAnyAlphabet) {
  Scene scene = oscillator();
  scene.title = "Ley de Hooke: ¿qué? `rm` \"x\"";
  EXPECT_NO_THROW(figuresOf(scene, runScene(scene)));
}

}  // namespace
}  // namespace muelle::lab
