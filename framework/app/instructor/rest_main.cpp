/// \file
/// `muelle rest`: reads its command line, has the lab find a scene's equilibrium, prints the summary.

#include "base/command_line.h"
#include "base/errors.h"
#include "lab/rest/rest_figure.h"
#include "lab/rest/rest_scene.h"
#include "lab/rest/rest_tables.h"
#include "lab/run/result_files.h"
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
  RestOptions options;
  std::string out;
  bool plot = false;
  bool csv = false;
};

void writeResults(const Command& command, const Scene& scene, const SceneAtRest& rest) {
  if (!command.plot && !command.csv) return;
  const ResultFiles files(command.out, scene.name);
  if (command.plot) files.draw({figureOf(scene, rest)});
  if (command.csv) {
    for (const fs::path& file : writeTables(scene, rest, files.folder())) ResultFiles::nameTable(file);
  }
}

int rest(const Command& command) {
  if (command.scene.empty()) throw std::invalid_argument("SCENE is missing; ./muelle run --list names them");
  const Scene scene = readScene(findScene(command.scene, shippedScenes()));
  const SceneAtRest found = restScene(scene, command.options);
  fmt::print("{}", summaryOf(scene, found));
  writeResults(command, scene, found);
  if (found.result.isFound()) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "muelle: {}: no equilibrium: {}\n", scene.name, nameOf(found.result.verdict));
  return 1;
}

int parseAndRun(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle rest",
                              "Finds where a scene stands still, and says what kind of equilibrium that is.");
  program.option("SCENE", command.scene, "A scene by its name (./muelle run --list), or a file SCENE.toml");
  program.option("--at", command.options.time, "Time [s] at which motions, forces and moving obstacles are taken [0]");
  program.flag("--leave-saddles", command.options.leaveSaddles, "Go on downhill where the forces balance on a saddle");
  program.flag("--plot", command.plot, "Draw the shape and the tensions");
  program.flag("--csv", command.csv, "Write positions and tensions as tables, nodes as the scene numbers them");
  program.option("--out", command.out, "Folder for figure and tables [out/SCENE]");
  program.footer(
      "Verdicts: stable, saddle, neutral: the forces balance. cusp: nodes where the energy has no gradient, as two at\n"
      "          one place. unsupported: nothing carries the loads. none found: the search ended without balance.\n"
      "Exit code: 0 the forces balance; 1 they do not (cusp, unsupported, none found); 2 bad usage or input.\n"
      "Examples: ./muelle rest hanging_chain\n"
      "          ./muelle rest hanging_chain --plot --csv --out results\n"
      "          ./muelle rest corner_hung_cloth --leave-saddles\n"
      "          ./muelle rest rabbit_squeezed --at 0.6\n"
      "          ./muelle rest my_scene.toml");
  program.action([&command] { return rest(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndRun(argc, argv); });
}
