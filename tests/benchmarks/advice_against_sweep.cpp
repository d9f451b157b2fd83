/// \file
/// The adviser's choice against the full sweep of every method and setting, on the scenes of `muelle bench`: ratios of
/// times taken in turn, and the true error. The bar is 1.3.
///
///     muelle-benchmark-advice FOLDER [--quick] [SCENE ...]

#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"
#include "lab/advise/advice.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/statistics.h"
#include "lab/bench/stopwatch.h"
#include "lab/bench/sweep.h"
#include "lab/run/run_scene.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace muelle::bench;
namespace engine = muelle::engine;
namespace lab = muelle::lab;

/// The adviser reads scenes; what it is asked for is an error at the ends of steps, as the sweep measures it.
engine::Scene sceneOf(const BenchScene& scene) {
  engine::Scene asked;
  asked.name = scene.name;
  asked.title = scene.title;
  asked.model = scene.model;
  asked.method = "velocity_verlet";
  asked.step = scene.duration / 1000.0;
  asked.duration = scene.duration;
  asked.locateEvents = scene.locateEvents;
  return asked;
}

struct Ours {
  double seconds = 0.0;
  PathError error;
};

double larger(const PathError& error) { return std::max(error.position, error.velocity); }

/// A run of what was advised.
void advised(const engine::Scene& scene, const engine::ModelSystem& system, Path* path) {
  const engine::StepOptions options = lab::optionsOf(scene);
  const std::unique_ptr<engine::Integrator> method = engine::makeMethod(scene.method);
  engine::Simulation simulation(system, *method, system.initialState(), options);
  while (simulation.advance().goesOn()) {
    if (path != nullptr && path->wants(simulation.time())) path->see(pointOf(system, simulation.state()));
  }
}

/// The curves with the larger of both errors in place of e_x, which is what the adviser is asked for.
std::vector<Curve> curvesByError(const SceneResult& result) {
  std::vector<Curve> curves = result.curves;
  for (Curve& curve : curves) {
    for (CurvePoint& point : curve.points) point.error.position = larger(point.error);
  }
  return curves;
}

struct BestOfSweep {
  const Curve* curve = nullptr;
  Crossing crossing;
  double seconds = 0.0;
};

std::optional<BestOfSweep> bestAt(const std::vector<Curve>& curves, double target) {
  std::optional<BestOfSweep> best;
  for (const Curve& curve : curves) {
    const std::optional<Crossing> crossing = crossingAt(curve, target);
    if (!crossing) continue;
    const double seconds = secondsAt(curve, *crossing, 0);
    if (!best || seconds < best->seconds) best = {&curve, *crossing, seconds};
  }
  return best;
}

/// Both in turn; the ratio of each round.
Statistics ratioOf(const engine::Scene& scene, const engine::ModelSystem& system, Contestant& rival,
                   const BestOfSweep& best) {
  constexpr int rounds = 9;
  constexpr double leastTimed = 2e-3;
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    const double ours = secondsOf([&] { advised(scene, system, nullptr); }, processorTime, leastTimed);
    const auto timed = [&](std::size_t point) {
      return secondsOf([&] { rival.run(best.curve->points[point].setting, nullptr); }, processorTime, leastTimed);
    };
    ratios.push_back(ours / atCrossing(best.crossing, timed(best.crossing.coarse), timed(best.crossing.fine)));
  }
  return statisticsOf(ratios);
}

void compare(const BenchScene& scene, const std::filesystem::path& folder) {
  const std::unique_ptr<engine::ModelSystem> system = engine::build(scene.model);
  const Reference reference(scene, *system, folder / (scene.name + ".reference"), "advice");
  std::vector<std::string> left;
  const Contestants contestants = engineContestants(scene, *system, left);
  Record record(folder / "runs.tsv", "advice");
  SweepOptions options;
  options.rounds = 3;
  options.secondsOfRounds = 20.0;
  const SceneResult result = sweep(scene, contestants, reference, record, options);
  const std::vector<Curve> curves = curvesByError(result);
  for (const double target : targets) {
    const lab::Advice advice = lab::advise(sceneOf(scene), {.tolerance = target, .budget = 20.0});
    const lab::Candidate* chosen = advice.chosen();
    const std::optional<BestOfSweep> best = bestAt(curves, target);
    if (chosen == nullptr || !best) {
      fmt::print("{:<18} {:.0e}  {}; best of the sweep: {}\n", scene.name, target,
                 chosen == nullptr ? advice.refusal : chosen->setting.name(), best ? best->curve->method : "none");
      continue;
    }
    const std::unique_ptr<engine::ModelSystem> rest = engine::build(advice.scene.model);
    Path path(scene.duration, scene.samples);
    advised(advice.scene, *rest, &path);
    const auto rival = std::ranges::find(contestants, best->curve->key(), [](const auto& c) { return c->key(); });
    const Statistics ratio = ratioOf(advice.scene, *rest, **rival, *best);
    fmt::print(
        "{:<18} {:.0e}  {:<26} {:<20} true {:.2g} said {:.2g}  ratio {:.2f} [{:.2f} {:.2f}] to {}  cost {:.2g} s\n",
        scene.name, target, chosen->setting.name(), chosen->setting.valueText(), larger(reference.errorOf(path)),
        chosen->error, ratio.median, ratio.low, ratio.high, best->curve->method, advice.seconds);
    if (ratio.low > 1.3) fmt::print("{}", lab::adviceText(advice.scene, advice));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: muelle-benchmark-advice FOLDER [--quick] [SCENE ...]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  bool quick = false;
  std::vector<std::string> names;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--quick") {
      quick = true;
    } else {
      names.push_back(word);
    }
  }
  for (const std::string& name : names.empty() ? sceneNames() : names) {
    BenchScene scene = makeScene(name);
    if (quick && scene.quickDuration > 0.0) scene.duration = scene.quickDuration;
    compare(scene, folder);
  }
}
