/// \file
/// The program behind `muelle bench`: speed against error of every method and of the libraries that a user would pick
/// instead, in one run.

#include "base/build_paths.h"
#include "base/command_line.h"
#include "base/errors.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "engine/model/model_system.h"
#include "figures/write.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/report.h"
#include "lab/bench/scaling.h"
#include "peers/peers.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace {

namespace fs = std::filesystem;
using namespace muelle::bench;

struct Command {
  std::vector<std::string> scenes;
  std::string out = "out/bench";
  std::string note;
  double longest = 5.0, springs = 1e7;
  int rounds = 15;
  bool quick = false, list = false, keep = false, scaling = false;
};

SweepOptions optionsOf(const Command& command) {
  SweepOptions options;
  options.longestRun = command.longest;
  options.rounds = command.rounds;
  if (!command.quick) return options;
  options.longestRun = std::min(0.15, command.longest);
  options.leastTimed = 2e-4;
  options.rounds = std::min(5, command.rounds);
  options.secondsOfRounds = 2.0;
  options.toleranceFactor = 0.01;
  options.stepFactor = 0.25;
  options.closeness = 1.1;
  return options;
}

/// What --quick runs: one or two of each kind, those that have been ahead.
bool isQuick(const Contestant& contestant) {
  static const std::vector<std::string> methods = {"symplectic_euler",
                                                   "velocity_verlet",
                                                   "runge_kutta_4",
                                                   "dop853",
                                                   "nystrom8",
                                                   "nystrom12",
                                                   "nystrom12_fixed",
                                                   "bdf2",
                                                   "rk4",
                                                   "fehlberg78",
                                                   "rk8pd",
                                                   "sb3a_m4",
                                                   "bulirsch_stoer",
                                                   "cvode_adams",
                                                   "cvode_bdf_klu",
                                                   "dopri5_dense_bisection"};
  return std::ranges::find(methods, contestant.method()) != methods.end();
}

BenchScene sceneFor(const std::string& name, const Command& command) {
  BenchScene scene = makeScene(name);
  if (command.quick && scene.quickDuration > 0.0) scene.duration = scene.quickDuration;
  return scene;
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
  muelle::ProgressBar bar(scene.name);
  const std::unique_ptr<muelle::engine::ModelSystem> system = muelle::engine::build(scene.model);
  std::vector<std::string> left;
  Contestants contestants = engineContestants(scene, *system, left);
  const Peers peers(scene, *system);
  peers.addTo(contestants);
  if (command.quick) std::erase_if(contestants, [](const auto& contestant) { return !isQuick(*contestant); });
  Reference reference(scene, *system, fs::path(command.out) / "kept" / (scene.name + ".reference"), stamp);
  judge(reference, scene, contestants, record);
  SweepOptions options = optionsOf(command);
  options.progress = [&bar](double fraction) { bar.update(fraction); };
  SceneResult result = sweep(scene, contestants, reference, record, options);
  result.amplification = reference.amplification();
  result.left = std::move(left);
  return result;
}

/// What was found, and what is promised of it.
struct Findings {
  std::vector<SceneResult> scenes;
  std::vector<Bar> bars;
  std::vector<std::string> missing;
  std::optional<Scaling> scaling;
};

/// A line for the page: how alone the program was. Its times are the processor's, but caches and clock rate are shared.
std::string noteOf(const Command& command, const Findings& found) {
  double busy = 0.0;
  for (const SceneResult& scene : found.scenes) busy += scene.busy / static_cast<double>(found.scenes.size());
  std::string note = fmt::format("{:.1f} other processes wanted a processor on average", busy);
  if (command.quick) note += "; --quick: coarse settings, few methods";
  return command.note.empty() ? note : note + "; " + command.note;
}

void writeTables(const Command& command, const Findings& found, const fs::path& folder) {
  if (!found.scenes.empty()) {
    muelle::writeFile(folder / "points.csv", pointsCsv(found.scenes));
    muelle::writeFile(folder / "plane.csv", planeCsv(found.scenes));
  }
  if (found.scaling) muelle::writeFile(folder / "scaling.csv", scalingCsv(*found.scaling));
  muelle::writeFile(folder / "bars.csv", barsCsv(found.bars));
  const Machine machine = thisMachine();
  muelle::writeFile(folder / "machine.txt",
                    fmt::format("{}, {}\n{}, {}\n{}, {}\n{}\n", machine.processor, machine.instructionSet,
                                machine.compiler, machine.flags, machine.system, machine.date, noteOf(command, found)));
}

/// The page and its pictures, in `folder` and `folder`/speed.
void writePage(const Command& command, const Findings& found, const fs::path& folder) {
  std::vector<muelle::Figure> figures;
  for (const SceneResult& result : found.scenes) figures.push_back(figureOf(result));
  if (!figures.empty()) {
    // A script and its data for each would bury the pictures.
    const muelle::TemporaryFolder drawn(folder);
    muelle::writeFigures(figures, drawn.path(), {muelle::Format::Png});
    fs::create_directories(folder / "speed");
    for (const muelle::Figure& figure : figures) {
      const std::string name = figure.id() + ".png";
      fs::copy_file(drawn.path() / name, folder / "speed" / name, fs::copy_options::overwrite_existing);
    }
  }
  muelle::writeFile(folder / "speed.md",
                    page(found.scenes, found.bars, thisMachine(), Peers::versions(), noteOf(command, found),
                         found.scaling ? scalingSection(*found.scaling) : ""));
}

void runScenes(const Command& command, Findings& found) {
  const std::string stamp = programStamp() + (command.quick ? " quick" : "");
  Record record(fs::path(command.out) / "kept" / (command.quick ? "quick.tsv" : "runs.tsv"), stamp);
  if (record.found() > 0) fmt::print(stderr, "muelle: goes on from {} runs\n", record.found());
  for (const std::string& name : chosen(command)) {
    found.scenes.push_back(runScene(sceneFor(name, command), record, command, stamp));
    fmt::print("{}", tableText(found.scenes.back()));
    std::fflush(stdout);
    for (Bar& bar : barsOf(found.scenes.back())) found.bars.push_back(std::move(bar));
    for (std::string& line : missingCurves(found.scenes.back())) found.missing.push_back(std::move(line));
  }
}

void runScaling(const Command& command, Findings& found) {
  ScalingOptions options;
  options.mostSprings = command.quick ? std::min(1e5, command.springs) : command.springs;
  muelle::ProgressBar bar("scaling");
  options.progress = [&bar](double fraction) { bar.update(fraction); };
  found.scaling = measureScaling(options);
  fmt::print("{}", scalingText(*found.scaling));
  for (Bar& one : barsOf(*found.scaling)) found.bars.push_back(std::move(one));
}

int bench(const Command& command) {
  if (command.list) {
    for (const std::string& name : sceneNames()) fmt::print("{:<18} {}\n", name, makeScene(name).title);
    return 0;
  }
  for (const std::string& name : command.scenes) makeScene(name);  // a wrong name is told before the first run
  fs::create_directories(fs::path(command.out) / "kept");
  Findings found;
  if (command.scaling) runScaling(command, found);
  if (!command.scaling || !command.scenes.empty() || command.keep) runScenes(command, found);
  writeTables(command, found, command.out);
  writePage(command, found, command.out);
  if (command.keep) {
    const fs::path source = muelle::build_paths::source;
    const fs::path results = source / "tests" / "benchmarks" / "results" / thisMachine().slug();
    fs::create_directories(results);
    writeTables(command, found, results);
    writePage(command, found, source / "docs");
    fmt::print("kept: {} and docs/speed.md\n", fs::relative(results, source).string());
  }
  fmt::print("{}", barsText(found.bars));
  std::fflush(stdout);
  for (const std::string& line : found.missing) fmt::print(stderr, "muelle: {}\n", line);
  return found.missing.empty() ? 0 : 1;
}

int parseAndRun(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle bench", "Speed against error, of every method and of other libraries.");
  program.option("--scene", command.scenes, "Only these scenes [all]");
  program.flag("--quick", command.quick, "Some scenes, coarse settings, five rounds: under 90 s");
  program.option("--out", command.out, "Folder for tables, figures and the record of runs").showDefault();
  program.flag("--scaling", command.scaling,
               "Time and memory from 1e3 to 1e7 springs; scenes only with --scene or --keep");
  program.option("--springs", command.springs, "With --scaling: up to so many springs").showDefault();
  program.option("--rounds", command.rounds, "Interleaved runs of what competes for an entry")
      .range(1, 1000)
      .showDefault();
  program.option("--longest", command.longest, "No run is begun that is foreseen to take longer [s]").showDefault();
  program.flag("--keep", command.keep, "Also keep tables in tests/benchmarks/results, and write docs/speed.md");
  program.option("--note", command.note, "A line for the page: what else the machine did");
  program.flag("--list", command.list, "Name the scenes, run none");
  program.footer(
      "Broken off, it goes on where it was: type the same again.\n"
      "Exit code: 1 when a curve is missing or crashed, else 0; missed bars are said and change nothing.\n"
      "Examples: ./muelle bench --quick\n"
      "          ./muelle bench --scene pendulum chain\n"
      "          ./muelle bench --scaling\n"
      "          ./muelle bench --scaling --keep --note \"nothing else ran\"");
  program.action([&command] { return bench(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndRun(argc, argv); });
}
