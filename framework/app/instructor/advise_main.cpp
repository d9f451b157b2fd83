/// \file
/// `muelle advise`: reads its command line, has the lab find what a scene needs, prints the advice.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/progress_bar.h"
#include "lab/advise/advice.h"
#include "lab/advise/advice_figure.h"
#include "lab/advise/applied_scene.h"
#include "lab/run/result_files.h"
#include "lab/run/shipped_scenes.h"
#include "lab/run/summary_line.h"

#include <fmt/format.h>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

using namespace muelle::engine;
using namespace muelle::lab;

struct Command {
  std::string scene;
  std::optional<double> tolerance;
  AdviceOptions options;
  std::string apply;
  std::string out;
  bool plot = false;
};

/// Says so where a file was there already.
void apply(const Command& command, const std::filesystem::path& file, const Advice& advice) {
  const bool was = std::filesystem::exists(command.apply);
  const AppliedScene applied = writeApplied(file, advice, command.apply);
  fmt::print("{}", summaryLine("applied", command.apply + (was ? ", in place of what was there" : "")));
  for (const std::string& part : applied.notSaid) fmt::print("{}", summaryLine("not in it", part));
}

int advise(const Command& command) {
  if (command.scene.empty()) throw std::invalid_argument("SCENE is missing; ./muelle run --list names them");
  if (!command.tolerance) {
    throw std::invalid_argument("--tolerance is missing: the error that is allowed in parts of the motion, as 1e-4");
  }
  const std::filesystem::path file = findScene(command.scene, shippedScenes());
  const Scene scene = readScene(file);
  if (!command.apply.empty()) checkTarget(file, command.apply);
  AdviceOptions options = command.options;
  options.tolerance = *command.tolerance;
  Advice advice;
  {
    muelle::ProgressBar bar(scene.name);
    options.progress = [&bar](double fraction) { bar.update(fraction); };
    advice = advise(scene, options);
  }
  fmt::print("{}", adviceText(scene, advice));
  if (command.plot || !command.out.empty()) ResultFiles(command.out, scene.name).draw({figureOf(scene, advice)});
  if (!command.apply.empty() && advice.chosen() != nullptr) apply(command, file, advice);
  std::fflush(stdout);
  if (advice.chosen() != nullptr) return 0;
  fmt::print(stderr, "muelle: {}: no statement at {:.2g}: {}\n", scene.name, advice.tolerance, advice.refusal);
  return 1;
}

int parseAndRun(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle advise",
                              "Finds the cheapest method, step and model that run a scene within an error.");
  program.option("SCENE", command.scene, "A scene by its name (./muelle run --list), or a file SCENE.toml");
  program.option("--tolerance", command.tolerance,
                 "The error that is allowed, in parts of the motion: above 0, at most 1");
  program.option("--budget", command.options.budget, "Time [s] that the advice may take [10]");
  program.option("--apply", command.apply, "Write the scene as advised to this file, FILE.toml");
  program.flag("--plot", command.plot, "Draw error against time, of methods and of the model without its parts");
  program.option("--out", command.out, "Draw into this folder [with --plot: out/SCENE]");
  program.footer(
      "Exit code: 0 there is a choice; 1 nothing can be said, with the reason; 2 bad usage or input.\n"
      "Examples: ./muelle advise elastic_pendulum --tolerance 1e-4\n"
      "          ./muelle advise hanging_chain --tolerance 1e-2 --plot --budget 30\n"
      "          ./muelle advise my_scene.toml --tolerance 1e-3 --apply advised.toml && ./muelle run advised.toml");
  program.action([&command] { return advise(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndRun(argc, argv); });
}
