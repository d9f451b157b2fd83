/// \file
/// `muelle run`: reads its command line, has the engine run a scene, prints the summary.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/text/printable.h"
#include "engine/integrators/catalogue.h"
#include "harness/trajectory.h"
#include "lab/run/error_estimate.h"
#include "lab/run/foresight.h"
#include "lab/run/result_files.h"
#include "lab/run/run_scene.h"
#include "lab/run/scene_figures.h"
#include "lab/run/shipped_scenes.h"

#include <fmt/format.h>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace muelle::engine;
using namespace muelle::lab;

struct Command {
  std::string scene;
  RunOverrides overrides;
  std::string events;
  std::string out;
  bool plot = false;
  bool csv = false;
  bool list = false;
  bool methods = false;
  bool noErrorEstimate = false;
  bool parts = false;
};

int listScenesWithTitles() {
  for (const fs::path& file : listScenes(shippedScenes())) {
    const Scene scene = readScene(file);
    fmt::print("{:<24} {}\n{:<24} {}\n{:<24} (slide: {})\n", scene.name, scene.title, "", scene.shows, "", scene.slide);
  }
  return 0;
}

int listMethods() {
  for (const std::string& id : methodIds()) {
    const MethodInfo& info = methodInfo(id);
    fmt::print("{:<28} order {:<2} {}\n", id, info.order, info.name);
  }
  return 0;
}

void writeResults(const Command& command, const Scene& scene, const SceneRun& run) {
  if (!command.plot && !command.csv) return;
  const ResultFiles files(command.out, scene.name);
  if (command.plot) files.draw(figuresOf(scene, run));
  if (command.csv) {
    const fs::path file = files.folder() / (scene.name + ".csv");
    muelle::writeCsv(trajectoryOf(run), axesOf(run.system->model()), file);
    ResultFiles::nameTable(file);
  }
}

/// Where it takes long, before it begins.
void sayWhatIsForeseen(const Scene& scene) {
  const Foresight foresight = foresee(scene);
  const double available = availableMemory(), room = roomForOutputs(foresight, available);
  requireMemory(scene, foresight, available);
  if (foresight.isLong(room)) fmt::print(stderr, "{}: {}\n", scene.name, foreseenText(foresight, room));
}

int run(const Command& command) {
  if (command.list) return listScenesWithTitles();
  if (command.methods) return listMethods();
  if (command.scene.empty()) throw std::invalid_argument("SCENE is missing; ./muelle run --list names them");
  const Scene scene = applied(readScene(findScene(command.scene, shippedScenes())), command.overrides);
  sayWhatIsForeseen(scene);
  SceneRun result = runScene(scene, scene.name);
  if (!command.noErrorEstimate && !result.result.failed()) {
    result.error = estimateError(scene, result, scene.name + ", error");
  }
  fmt::print("{}", summaryOf(scene, result));
  if (command.parts) fmt::print("{}", workOfParts(result));
  writeResults(command, scene, result);
  std::fflush(stdout);
  if (result.result.failed()) {
    fmt::print(stderr, "muelle: {}: {}\n", scene.name, muelle::printableLine(result.result.trajectory.stop.message));
  } else if (result.energy.fails()) {
    fmt::print(stderr, "muelle: {}: {}\n", scene.name, energyFailure(result.energy));
  }
  return result.result.failed() || result.energy.fails() ? 1 : 0;
}

int parseAndRun(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle run", "Simulates a scene and says what it cost and how far it is off.");
  program.option("SCENE", command.scene, "A scene by its name (--list), or a file SCENE.toml");
  program.option("--method", command.overrides.method, "The method, by its id (--methods) [the scene's]");
  program.option("--step", command.overrides.step, "Fixed step [s] [the scene's]");
  program.option("--tolerance", command.overrides.tolerance,
                 "Relative tolerance of a method with an error estimate [the scene's]");
  program.option("--duration", command.overrides.duration, "Time to simulate [s] [the scene's]");
  program.option("--output-interval", command.overrides.outputInterval, "Time between outputs [s] [the scene's]");
  program
      .option("--events", command.events,
              "End steps at contacts and jumps, or (off) step over them [the scene's, or on]")
      .oneOf({"on", "off"});
  program.option("--without", command.overrides.without,
                 "Parts of the model to leave out, by name: gravity, cloth.bend (--parts names them)");
  program.flag("--compensated", command.overrides.compensated, "Compensated summation, for long runs");
  program.flag("--no-error-estimate", command.noErrorEstimate,
               "Leave out the runs with other steps, which cost two to seven times the first, more where it is short");
  program.flag("--parts", command.parts, "Say of each part of the model what it has cost");
  program.flag("--plot", command.plot, "Draw energy, outputs, shape and paths");
  program.flag("--csv", command.csv,
               "Write the trajectory as a table, with a column for each node and axis as the scene numbers them");
  program.option("--out", command.out, "Folder for figures and table [out/SCENE]");
  program.flag("--list", command.list, "Name the scenes, run none");
  program.flag("--methods", command.methods, "Name the methods, run none");
  program.renamed("--integrator", "--method ID");
  program.renamed("--dt", "--step SECONDS");
  program.renamed("--no-events", "--events off");
  program.footer(
      "Exit code: 0 done; 1 the run failed before its end, or gained energy that nothing gives; 2 bad usage or input.\n"
      "Examples: ./muelle run oscillator --plot\n"
      "          ./muelle run corner_hung_cloth --method velocity_verlet --step 1e-4\n"
      "          ./muelle run elastic_pendulum --method dop853 --tolerance 1e-12 --csv --out results\n"
      "          ./muelle run my_scene.toml");
  program.action([&command] {
    if (!command.events.empty()) command.overrides.events = command.events == "on";
    return run(command);
  });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndRun(argc, argv); });
}
