#include "lab/bench/scaling.h"

#include "base/file.h"
#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"
#include "engine/scene/scene.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/report.h"
#include "lab/hard_cases/models.h"
#include "lab/run/foresight.h"

#include <fmt/format.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace muelle::bench {

using namespace engine;

namespace {

/// What the process has allocated [byte]; 0 where the C library does not tell.
double allocatedMemory() {
#if defined(__GLIBC__)
  const struct mallinfo2 memory = mallinfo2();
  return static_cast<double>(memory.uordblks) + static_cast<double>(memory.hblkhd);
#else
  return 0.0;
#endif
}

/// Nodes a side of a cloth with about so many springs: six a node.
int sideOf(double springs) { return std::max(4, static_cast<int>(std::lround(std::sqrt(springs / 6.0)))); }

Model clothOf(double springs) { return waveCloth(sideOf(springs), 1e4, 0.0, 0.0); }

/// Seconds of a step: `steps` of them, so many that the least time passes, in each round.
Statistics timeSteps(const ModelSystem& system, const std::string& id, double h, const ScalingOptions& options) {
  const std::unique_ptr<Integrator> method = makeMethod(id);
  StepOptions stepping;
  stepping.duration = 1e6 * h;
  stepping.h = h;
  Simulation simulation(system, *method, system.initialState(), stepping);
  const auto step = [&simulation] {
    if (!simulation.advance().goesOn()) throw std::runtime_error("scaling: " + simulation.stop().message);
  };
  step();  // allocates
  std::vector<double> seconds;
  for (int round = 0; round < options.rounds; ++round) {
    seconds.push_back(secondsOf(step, options.now, options.leastTimed / options.rounds));
  }
  return statisticsOf(seconds);
}

ScalingRow rowFor(const std::string& kind, const Model& model, const std::string& method, double h,
                  const ScalingOptions& options) {
  ScalingRow row;
  row.kind = kind;
  row.springs = std::ssize(model.springs);
  row.unknowns = unknownsOf(model);
  const double before = allocatedMemory(), begin = options.now();
  const std::unique_ptr<ModelSystem> system = build(model);
  row.build = options.now() - begin;
  row.bytes = std::max(0.0, allocatedMemory() - before);
  row.step = timeSteps(*system, method, h, options);
  return row;
}

/// Whether a scene of so many springs fits: what the last one took, ten times.
bool fits(const Scaling& scaling, double springs, const std::string& what, std::vector<std::string>& notes) {
  constexpr double bytesASpring = 700.0;  // model, system and states while both are there
  if (springs * bytesASpring < lab::availableMemory()) return true;
  notes.push_back(fmt::format("{} with {:.0e} springs is left out: memory", what, springs));
  return scaling.rows.empty();
}

void measureExplicit(Scaling& scaling, const ScalingOptions& options) {
  for (double springs = 1e3; springs <= 1.01 * options.mostSprings; springs *= 10.0) {
    if (!fits(scaling, springs, "cloth", scaling.notes)) break;
    {
      const Model model = clothOf(springs);
      scaling.rows.push_back(rowFor("grid", model, "velocity_verlet", 1e-7, options));
    }
    std::vector<std::size_t> place;
    const Model model = shuffled(clothOf(springs), place);
    scaling.rows.push_back(rowFor("general", model, "velocity_verlet", 1e-7, options));
    options.progress(0.5 * std::log10(springs / 100.0) / std::log10(options.mostSprings / 100.0));
  }
}

void measureImplicit(Scaling& scaling, const std::string& method, const ScalingOptions& options) {
  for (double springs = 1e3; springs <= options.mostSprings; springs *= std::sqrt(10.0)) {
    // A factor of a matrix of a sheet has some 31 n log2 n numbers [George and Liu 1981]; three blocks a node.
    const double nodes = springs / 6.0, factor = 9.0 * 31.0 * nodes * std::log2(nodes) * 8.0;
    if (factor > 0.5 * lab::availableMemory()) {
      scaling.notes.push_back(fmt::format("{} beyond {:.0f} nodes is left out: memory", method, nodes));
      return;
    }
    scaling.rows.push_back(rowFor(method, clothOf(springs), method, 1e-3, options));
    if (scaling.rows.back().step.median > 0.1 * options.longestStep) {
      scaling.notes.push_back(fmt::format("{} beyond {:.0f} nodes is left out: time", method, nodes));
      return;
    }
  }
}

constexpr const char* sceneFile = R"(title = "Scaling"
shows = "what reading takes"
slide = "Todo junto..."
gravity = 9.81
[[object]]
kind = "grid"
name = "cloth"
nodes = [{0}, {0}]
spacing = 0.01
mass = 1.0
k = 1e4
shear_stiffness = 1e4
bend_stiffness = 1e4
[[pin]]
object = "cloth"
nodes = [0, {1}]
[run]
method = "velocity_verlet"
step = 1e-5
duration = 1.0
)";

void measureFiles(Scaling& scaling, const ScalingOptions& options) {
  const TemporaryFolder folder(std::filesystem::temp_directory_path());
  const std::filesystem::path file = folder.path() / "scaling.toml";
  for (double springs = 1e3; springs <= std::min(1e6, options.mostSprings); springs *= 10.0) {
    const int n = sideOf(springs);
    writeFile(file, fmt::format(fmt::runtime(sceneFile), n, n - 1));
    ScalingRow row;
    row.kind = "files";
    Scene scene;
    row.read = secondsOf([&] { scene = readScene(file); }, options.now, 0.0);
    std::unique_ptr<ModelSystem> system;
    row.build = secondsOf([&] { system = build(scene.model); }, options.now, 0.0);
    row.springs = std::ssize(scene.model.springs);
    row.unknowns = unknownsOf(scene.model);
    const PathPoint point = pointOf(*system, system->initialState());
    Trajectory trajectory;
    trajectory.t = {0.0};
    trajectory.x = {point.x};
    trajectory.v = {point.v};
    row.write = secondsOf([&] { writeCsv(trajectory, "xyz", folder.path() / "scaling.csv"); }, options.now, 0.0);
    scaling.rows.push_back(row);
  }
}

void measureMeanHeight(Scaling& scaling, const ScalingOptions& options) {
  const std::unique_ptr<ModelSystem> system = build(hard_cases::meanHeight(100'000));
  scaling.meanHeightStep = timeSteps(*system, "backward_euler", 0.01, options);
  const State from = system->initialState();
  State to = from;
  std::vector<double> seconds;
  for (int round = 0; round < options.rounds; ++round) {
    seconds.push_back(secondsOf(
        [&] {
          std::ranges::copy(from.x, to.x.begin());
          std::ranges::copy(from.v, to.v.begin());
        },
        options.now, options.leastTimed / options.rounds));
  }
  scaling.copying = statisticsOf(seconds);
}

double perSpring(const ScalingRow& row) { return 1e9 * row.step.median / static_cast<double>(row.springs); }

bool isExplicit(const ScalingRow& row) { return row.kind == "grid" || row.kind == "general"; }

Bar spreadBar(const Scaling& scaling, const std::string& kind, double most) {
  Bar bar{.where = fmt::format("time per spring, {}", kind),
          .promise = fmt::format("within {:g} times from 1e4 to 1e7 springs", most),
          .measured = {}};
  double least = 0.0, greatest = 0.0, largest = 0.0;
  for (const ScalingRow& row : scaling.rows) {
    if (row.kind != kind || row.springs < 8'000) continue;
    least = least == 0.0 ? perSpring(row) : std::min(least, perSpring(row));
    greatest = std::max(greatest, perSpring(row));
    largest = static_cast<double>(row.springs);
  }
  if (least == 0.0) return bar;
  bar.measured = fmt::format("{:.2f}: {:.3g} to {:.3g} ns a spring and step, up to {:.1e} springs", greatest / least,
                             least, greatest, largest);
  const bool whole = largest > 9e6;
  bar.verdict = greatest > most * least ? Bar::Verdict::Missed : whole ? Bar::Verdict::Met : Bar::Verdict::NotMeasured;
  return bar;
}

}  // namespace

Scaling measureScaling(const ScalingOptions& options) {
  Scaling scaling;
  measureMeanHeight(scaling, options);
  measureExplicit(scaling, options);
  measureFiles(scaling, options);
  options.progress(0.7);
  for (const char* method : {"linearised_backward_euler", "bdf2"}) measureImplicit(scaling, method, options);
  options.progress(1.0);
  return scaling;
}

std::vector<Bar> barsOf(const Scaling& scaling) {
  std::vector<Bar> bars = {spreadBar(scaling, "general", 2.5), spreadBar(scaling, "grid", 2.0)};
  Bar step{.where = "H05, 1e5 uncoupled nodes",
           .promise = "an implicit step at most 40 times copying x and v",
           .measured = {}};
  if (scaling.copying.count > 0) {
    const double ratio = scaling.meanHeightStep.median / scaling.copying.median;
    step.measured = fmt::format("{:.1f}: {} to {}", ratio, timeText(scaling.meanHeightStep.median),
                                timeText(scaling.copying.median));
    step.verdict = ratio <= 40.0 ? Bar::Verdict::Met : Bar::Verdict::Missed;
  }
  bars.push_back(step);
  return bars;
}

std::string scalingText(const Scaling& scaling) {
  std::string text = "Scaling\n";
  for (const ScalingRow& row : scaling.rows) {
    text += fmt::format("  {:<26} {:>9} springs {:>9} unknowns", row.kind, row.springs, row.unknowns);
    if (row.kind == "files") {
      text +=
          fmt::format("  read {}, build {}, write {}\n", timeText(row.read), timeText(row.build), timeText(row.write));
      continue;
    }
    text += isExplicit(row) ? fmt::format("  {:.3g} ns a spring and step", perSpring(row))
                            : fmt::format("  {:.3g} ns an unknown and step",
                                          1e9 * row.step.median / static_cast<double>(row.unknowns));
    text += fmt::format(", {:.0f} bytes a spring, build {}\n", row.bytes / static_cast<double>(row.springs),
                        timeText(row.build));
  }
  for (const std::string& note : scaling.notes) text += "  " + note + "\n";
  return text;
}

std::string scalingCsv(const Scaling& scaling) {
  std::string text = "kind,springs,unknowns,step_s,step_low_s,step_high_s,bytes,build_s,read_s,write_s\n";
  for (const ScalingRow& row : scaling.rows) {
    text +=
        fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.0f},{:.4g},{:.4g},{:.4g}\n", row.kind, row.springs, row.unknowns,
                    row.step.median, row.step.low, row.step.high, row.bytes, row.build, row.read, row.write);
  }
  return text;
}

std::string scalingSection(const Scaling& scaling) {
  std::string text =
      "## Size\n\n"
      "Velocity Verlet on cloth in order (grid) and in random order (general), implicit methods on the same cloth.\n"
      "Memory is what building has taken, the model aside.\n\n"
      "| | springs | unknowns | a step | ns a spring | ns an unknown | bytes a spring | build |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const ScalingRow& row : scaling.rows) {
    if (row.kind == "files") continue;
    text += fmt::format("| {} | {} | {} | {} | {:.3g} | {:.3g} | {:.0f} | {} |\n", row.kind, row.springs, row.unknowns,
                        timeText(row.step.median), perSpring(row),
                        1e9 * row.step.median / static_cast<double>(row.unknowns),
                        row.bytes / static_cast<double>(row.springs), timeText(row.build));
  }
  text += "\n| scene file | springs | read | build | write a table of all nodes |\n|---|---|---|---|---|\n";
  for (const ScalingRow& row : scaling.rows) {
    if (row.kind != "files") continue;
    text += fmt::format("| grid | {} | {} | {} | {} |\n", row.springs, timeText(row.read), timeText(row.build),
                        timeText(row.write));
  }
  for (const std::string& note : scaling.notes) text += "\n" + note + ".\n";
  return text + "\n";
}

}  // namespace muelle::bench
