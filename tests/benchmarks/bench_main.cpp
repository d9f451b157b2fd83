/// \file
/// The program behind `muelle bench`: speed against error of every method and of the libraries that a user would pick
/// instead, in one run.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "engine/model/model_system.h"
#include "figures/write.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/report.h"
#include "peers/peers.h"

#include <fmt/format.h>
#include <cstdio>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace muelle::bench;

struct Command {
  std::vector<std::string> scenes;
  std::string out = "out/bench";
  bool quick = false, list = false, keep = false;
};

SweepOptions optionsOf(const Command& command) {
  SweepOptions options;
  if (!command.quick) return options;
  options.longestRun = 0.05;
  options.leastTimed = 2e-4;
  options.rounds = 5;
  options.secondsOfRounds = 2.0;
  options.toleranceFactor = 0.01;
  options.stepFactor = 0.25;
  options.closeness = 1.1;
  return options;
}

std::vector<std::string> chosen(const Command& command) {
  if (!command.scenes.empty()) return command.scenes;
  std::vector<std::string> names;
  for (const std::string& name : sceneNames()) {
    if (!command.quick || makeScene(name).quick) names.push_back(name);
  }
  return names;
}

SceneResult runScene(const BenchScene& scene, Record& record, const Command& command, const std::string& stamp) {
  const std::unique_ptr<muelle::engine::ModelSystem> system = muelle::engine::build(scene.model);
  std::vector<std::string> left;
  Contestants contestants = engineContestants(scene, *system, left);
  const Peers peers(scene, *system);
  peers.addTo(contestants);
  muelle::ProgressBar bar(scene.name);
  Reference reference(scene, *system, fs::path(command.out) / "kept" / (scene.name + ".reference"), stamp);
  judge(reference, scene, contestants, record);
  SweepOptions options = optionsOf(command);
  options.progress = [&bar](double fraction) { bar.update(fraction); };
  SceneResult result = sweep(scene, contestants, reference, record, options);
  result.amplification = reference.amplification();
  result.left = std::move(left);
  return result;
}

void write(const Command& command, const std::vector<SceneResult>& results, const std::vector<Bar>& bars) {
  const fs::path out = command.out;
  muelle::writeFile(out / "points.csv", pointsCsv(results));
  muelle::writeFile(out / "plane.csv", planeCsv(results));
  std::vector<muelle::Figure> figures;
  for (const SceneResult& result : results) figures.push_back(figureOf(result));
  muelle::writeFigures(figures, out / "speed", {muelle::Format::Svg, muelle::Format::Png});
  muelle::writeFile(out / "speed.md", page(results, bars, thisMachine(), Peers::versions(), "as it was", ""));
}

int bench(const Command& command) {
  if (command.list) {
    for (const std::string& name : sceneNames()) fmt::print("{:<18} {}\n", name, makeScene(name).title);
    return 0;
  }
  fs::create_directories(fs::path(command.out) / "kept");
  const std::string stamp = programStamp() + (command.quick ? " quick" : "");
  Record record(fs::path(command.out) / "kept" / (command.quick ? "quick.tsv" : "runs.tsv"), stamp);
  std::vector<SceneResult> results;
  std::vector<Bar> bars;
  std::vector<std::string> missing;
  for (const std::string& name : chosen(command)) {
    results.push_back(runScene(makeScene(name), record, command, stamp));
    fmt::print("{}", tableText(results.back()));
    std::fflush(stdout);
    for (Bar& bar : barsOf(results.back())) bars.push_back(std::move(bar));
    for (std::string& line : missingCurves(results.back())) missing.push_back(std::move(line));
  }
  write(command, results, bars);
  fmt::print("{}", barsText(bars));
  std::fflush(stdout);
  for (const std::string& line : missing) fmt::print(stderr, "muelle: {}\n", line);
  return missing.empty() ? 0 : 1;
}

int parseAndRun(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle bench", "Speed against error, of every method and of other libraries.");
  program.option("--scene", command.scenes, "Only these scenes [all]");
  program.flag("--quick", command.quick, "Some scenes, coarse settings, five rounds: under 90 s");
  program.option("--out", command.out, "Folder for tables, figures and the record of runs").showDefault();
  program.flag("--list", command.list, "Name the scenes, run none");
  program.footer(
      "Broken off, it goes on where it was: type the same again.\n"
      "Exit code: 1 when a curve is missing or crashed, else 0; missed bars are said and change nothing.\n"
      "Examples: ./muelle bench --quick\n"
      "          ./muelle bench --scene pendulum chain\n"
      "          ./muelle bench");
  program.action([&command] { return bench(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndRun(argc, argv); });
}
