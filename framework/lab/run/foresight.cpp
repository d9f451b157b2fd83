#include "lab/run/foresight.h"

#include "base/text/count.h"
#include "engine/control/simulate.h"
#include "engine/forces/layout.h"
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
  return element * static_cast<double>(model.nodes.size() + model.springs.size() + elementCount(model));
}

/// The numbers of a matrix: blocks of dimension x dimension, one a node, two for each pair of nodes that a spring
/// joins.
double matrixNumbers(const Model& model) {
  const double blocks = static_cast<double>(model.nodes.size()) + 2.0 * static_cast<double>(model.springs.size());
  return blocks * model.dimension * model.dimension;
}

bool isDamped(const Model& model) {
  return std::ranges::any_of(model.springs,
                             [](const ModelSpring& s) { return s.dRelative > 0.0 || s.dProjected > 0.0; }) ||
         std::ranges::any_of(model.nodes, [](const ModelNode& node) { return node.drag > 0.0; }) ||
         std::ranges::any_of(model.obstacles,
                             [](const Obstacle& o) { return o.material.d > 0.0 || o.material.mu > 0.0; });
}

double matrixBytes(const Model& model) {
  // The matrix itself and, never sparser, its factor; with damping those of stiffness and damping besides.
  const double copies = isDamped(model) ? 4.0 : 2.0;
  return copies * matrixNumbers(model) * number;
}

/// What stability() takes of a method that has a limit: the matrix with its indices and the plan of where elements go,
/// and 40 vectors of a Krylov space; with damping a second matrix, and the space is one of positions and velocities.
double lookBytes(const Model& model, double unknowns) {
  const double parts = isDamped(model) ? 2.0 : 1.0;
  constexpr double vectors = 42.0, withIndex = number + sizeof(int);
  return parts * vectors * unknowns * number + (1.0 + parts) * matrixNumbers(model) * withIndex;
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

double Foresight::peak(double room) const { return system() + std::max(look, kept(room) * output); }

bool Foresight::isLong(double room) const {
  // A spring's force and a node's share of a step take about 20 ns together for each coordinate of a node in a surface.
  constexpr double aStep = 20e-9, patience = 5.0, muchMemory = 256.0 * 1024.0 * 1024.0;
  return steps.value_or(outputs.value_or(0.0)) * unknowns * aStep > patience || peak(room) > muchMemory;
}

std::string foreseenText(const Foresight& foresight, double room) {
  std::string text = "foreseen: ";
  text += foresight.steps ? "about " + countText(*foresight.steps, "step") : "as many steps as the tolerance asks for";
  if (foresight.outputs) {
    text += ", " + countText(*foresight.outputs, "output");
    if (foresight.kept(room) < *foresight.outputs) {
      text += fmt::format(" (thinned to {} or fewer)", countText(std::floor(foresight.kept(room)), "output"));
    }
  }
  return text + ", about " + sizeText(foresight.peak(room));
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
  const double coordinates = static_cast<double>(model.nodes.size()) * Layout::padded(model.dimension, 1).storage;
  foresight.output = 2.0 * number * coordinates + number * static_cast<double>(1 + scene.outputs.size());
  foresight.model = modelBytes(model);
  foresight.state = number * coordinates * (6.0 + info.stages);  // x and v before, after and as told; a force a stage
  if (info.implicit) {
    constexpr double vectors = 24.0;  // of Newton's two points, of the stage, of the unknowns without what is held
    foresight.state += number * vectors * foresight.unknowns;
    foresight.matrices = matrixBytes(model);
  }
  const bool hasLimit = info.stability == Stability::Limited || info.stability == Stability::Never;
  if (hasLimit) foresight.look = lookBytes(model, foresight.unknowns);
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
