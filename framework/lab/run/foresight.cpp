#include "lab/run/foresight.h"

#include "base/text/count.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double leastOutputs = 1000.0;  // the engine thins outputs down to so many, not further
constexpr double number = sizeof(double);
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The scene's own model, the system's copy and its arrays: measured on grids, chains and boxes of 1e5 nodes and more
/// it is more than 300 bytes a node or spring.
double modelBytes(const Model& model) {
  constexpr double element = 300.0;
  return element * static_cast<double>(model.nodes.size() + model.springs.size() + model.angles.size() +
                                       model.dihedrals.size() + model.areas.size() + model.volumes.size());
}

/// Blocks of dimension x dimension numbers: one a node, two for each pair of nodes that a spring joins.
double matrixBytes(const Model& model) {
  const double blocks = static_cast<double>(model.nodes.size()) + 2.0 * static_cast<double>(model.springs.size());
  constexpr double copies = 2.0;  // the matrix itself and, never sparser, its factor
  return copies * blocks * model.dimension * model.dimension * number;
}

/// "1.2 GiB".
std::string sizeText(double bytes) {
  constexpr double kilo = 1024.0;
  const char* units[] = {"byte", "KiB", "MiB", "GiB", "TiB", "PiB"};
  std::size_t unit = 0;
  for (; unit + 1 < std::size(units) && bytes >= kilo; ++unit) bytes /= kilo;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

std::string countText(double count, const char* what) {
  return count < 1e15 ? countedInGroups(std::llround(count), what) : fmt::format("{:.3g} {}s", count, what);
}

/// What the process itself may still take beyond what it has [byte].
double ownLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  constexpr double page = 4096.0;  // at least
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - page * pages);
}

}  // namespace

double Foresight::kept(double room) const {
  const double most = std::max(leastOutputs, room / output);
  return std::min(outputs.value_or(2.0), most);  // an unknown number is at least start and end
}

Foresight foresee(const Scene& scene) {
  const Model& model = scene.model;
  const MethodInfo& info = methodInfo(scene.method);
  Foresight foresight;
  if (scene.step && !(info.adaptive && scene.tolerance)) foresight.steps = std::ceil(scene.duration / *scene.step);
  foresight.outputs = foresight.steps;
  if (scene.outputInterval > 0.0) foresight.outputs = std::ceil(scene.duration / scene.outputInterval);
  if (foresight.outputs) *foresight.outputs += 1.0;  // the start
  foresight.unknowns = static_cast<double>(model.dimension * std::ranges::count_if(model.nodes, isFree));
  const double lanes = model.dimension == 3 ? 4.0 : model.dimension;  // of a node
  const double coordinates = static_cast<double>(model.nodes.size()) * lanes;
  foresight.output = 2.0 * number * coordinates + number * static_cast<double>(1 + scene.outputs.size());
  foresight.model = modelBytes(model);
  foresight.state = number * coordinates * (6.0 + info.stages);  // x and v before, after and as told; a force a stage
  if (info.implicit) foresight.matrices = matrixBytes(model);
  return foresight;
}

double availableMemory(const std::filesystem::path& meminfo) {
  double available = unlimited;
  std::ifstream file(meminfo);
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view key = "MemAvailable:";
    if (line.starts_with(key)) available = 1024.0 * std::strtod(line.c_str() + key.size(), nullptr);
  }
  return std::min(available, ownLimit());
}

double roomForOutputs(const Foresight& foresight, double available) {
  return std::min(RunOptions{}.mostMemory, std::max(0.0, 0.25 * (available - foresight.system())));
}

void requireMemory(const Scene& scene, const Foresight& foresight, double available) {
  if (foresight.least() <= available) return;
  const double kept = foresight.kept(0.0);
  const double outputs = kept * foresight.output;
  std::string change = "make the scene smaller";
  if (outputs >= foresight.system()) {
    change = "give a longer output_interval";
  } else if (foresight.matrices >= foresight.model + foresight.state) {
    change =
        fmt::format("make the scene smaller, or take an explicit method, which has no matrices, for {}", scene.method);
  }
  std::string text =
      fmt::format("the run needs at least {} of memory, and {} are there: {} for {} and {}, {} for the state",
                  sizeText(foresight.least()), sizeText(available), sizeText(foresight.model),
                  countText(static_cast<double>(scene.model.nodes.size()), "node"),
                  countText(static_cast<double>(scene.model.springs.size()), "spring"), sizeText(foresight.state));
  if (foresight.matrices > 0.0) text += fmt::format(", {} for matrices", sizeText(foresight.matrices));
  text += fmt::format(", {} for {}", sizeText(outputs), countText(kept, "output"));
  if (foresight.outputs && *foresight.outputs > kept) {
    text += fmt::format(" (of {}; fewer are never kept)", countText(*foresight.outputs, "output"));
  }
  if (foresight.steps) text += fmt::format(" in {}", countText(*foresight.steps, "step"));
  throw std::invalid_argument(fmt::format("{}; {}", text, change));
}

}  // namespace muelle::lab
