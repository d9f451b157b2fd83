#include "lab/run/run_scene.h"

#include "base/text/count.h"
#include "base/text/printable.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/parts.h"
#include "engine/model/singular_points.h"
#include "engine/scene/selection.h"
#include "lab/run/summary_line.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t shownEvents = 6;
constexpr std::size_t shownWarnings = 20;

double positiveOption(const char* option, const char* unit, double value) {
  if (value > 0.0 && std::isfinite(value)) return value;
  throw std::invalid_argument(fmt::format("{} is {}{}; it must be positive and finite", option, value, unit));
}

/// An adaptive method takes its step by the tolerance, unless the scene has only a step for it.
bool isFixed(const Scene& scene) { return !methodInfo(scene.method).adaptive || !scene.tolerance; }

/// Whether the scene asks for springs in single precision.
bool asksForSingle(const SceneRun& run) { return run.system->model().precision == kernels::Precision::Single; }

/// What that changes nothing for, a line; empty where it does, or is not asked for.
std::vector<std::string> unusedPrecision(const SceneRun& run) {
  const char* changesNothing = "precision = \"single\" changes nothing";
  if (!asksForSingle(run)) return {};
  if (!run.system->mayBeSingle()) return {fmt::format("{}: no springs lie on a grid of 2D or 3D", changesNothing)};
  if (!run.method.implicit) return {};
  return {fmt::format("{}: {} balances forces in double", changesNothing, run.method.name)};
}

// --- lines of the summary ---

std::string stepLine(const Scene& scene, const SceneRun& run) {
  const Work& work = run.result.work;
  std::string text =
      isFixed(scene) ? fmt::format("h = {:.4g} s", run.options.h)
                     : fmt::format("chosen for a tolerance of {:.2g} of the motion", run.options.tolerance.relative);
  text += ", " + countedInGroups(work.steps, "step");
  if (work.inClosedForm > 0) text += fmt::format(", {} of them in closed form", grouped(work.inClosedForm));
  if (work.rejectedSteps > 0) text += fmt::format(", {} rejected", grouped(work.rejectedSteps));
  if (run.result.subdividedSteps > 0) {
    text += fmt::format(", {} cut so that nothing passes through an obstacle", grouped(run.result.subdividedSteps));
  }
  if (run.result.smallestStep > 0.0) text += fmt::format(", smallest {:.2g} s", run.result.smallestStep);
  return text;
}

std::string timeLine(const SceneRun& run) {
  const double t = run.result.last.t;
  const double wall = run.result.wallTime;
  std::string text = fmt::format("{:.6g} s simulated in {:.3g} s", t, wall);
  if (wall > 0.0) text += fmt::format(", {:.3g} times real time", t / wall);
  if (run.result.checkTime > 0.0) text += fmt::format("; {:.2g} s beside it to look at the step", run.result.checkTime);
  return text;
}

/// "0.014 of the motion", or the number with its unit where nothing moves.
std::string part(const PartError& error, const char* unit) {
  return error.absolute ? fmt::format("{:.2g} {}", error.value, unit) : fmt::format("{:.2g}", error.value);
}

std::string errorLine(const SceneRun& run) {
  if (!run.error) return "not estimated";
  const ErrorEstimate& estimate = *run.error;
  const std::string cost = estimate.wallTime > 0.0 ? fmt::format("; {:.2g} s more", estimate.wallTime) : "";
  if (!estimate.failure.empty()) return fmt::format("no estimate: {}{}", estimate.failure, cost);
  const std::string how = estimate.how + cost;
  if (estimate.absolute) {
    return fmt::format("{:.2g} m, {:.2g} m/s; nothing moves beyond rounding ({})", estimate.position, estimate.velocity,
                       how);
  }
  if (estimate.atRounding)
    return fmt::format("{:.2g} of the motion, the rounding of positions ({})", estimate.error(), how);
  return fmt::format("{:.2g} of the motion: positions {:.2g}, velocities {:.2g} ({})", estimate.error(),
                     estimate.position, estimate.velocity, how);
}

/// A line for each output of the scene.
std::string outputErrorLines(const Scene& scene, const ErrorEstimate& estimate) {
  std::string text;
  std::size_t i = 0;
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind == SceneOutput::Kind::Path || i >= estimate.outputs.size()) continue;
    const char* unit = output.kind == SceneOutput::Kind::Velocity ? "m/s" : "m";
    text += summaryLine("", fmt::format("{}: {}", output.name, part(estimate.outputs[i++], unit)));
  }
  return text;
}

std::string energyLine(const EnergyBalance& balance) {
  std::string text = fmt::format("{:.6g} J at the start, {:+.3g} J at the end, between {:+.3g} and {:+.3g} J",
                                 balance.start, balance.end, balance.lowest, balance.highest);
  if (balance.scale > 0.0) {
    const double most = std::max(balance.highest, -balance.lowest) / balance.scale;
    text += most < 0.995 ? fmt::format(" (up to {:.2g} % of", 100.0 * most) : fmt::format(" (up to {:.2g} times", most);
    text += fmt::format(" the scene's {:.3g} J)", balance.scale);
  }
  if (balance.interpolated) {
    text += fmt::format(" at the ends of steps; outputs between them are interpolated, and show up to {:+.3g} J",
                        *balance.interpolated);
  }
  if (balance.fate == EnergyFate::KeptOrLost) return text + "; it may be lost, not gained";
  if (balance.fate == EnergyFate::Open) return text + "; something drives the scene";
  return text;
}

std::string workLine(const Work& work) {
  std::string text = countedInGroups(work.forceEvaluations, "force evaluation");
  const auto add = [&](long long count, const char* what) {
    if (count > 0) text += ", " + countedInGroups(count, what);
  };
  add(work.jacobians, "Jacobian");
  add(work.factorisations, "factorisation");
  add(work.solves, "solve");
  add(work.newtonIterations, "Newton iteration");
  add(work.events, "event");
  return text;
}

std::string sizeLine(const Scene& scene, const SceneRun& run) {
  const Model& model = scene.model;
  std::string text = countedInGroups(std::ssize(model.nodes), "node");
  text += ", " + countedInGroups(std::ssize(model.springs), "spring");
  const auto add = [&](std::size_t count, const char* one, const char* several = "") {
    if (count > 0) text += ", " + countedInGroups(static_cast<long long>(count), one, several);
  };
  engine::forEachElementKind(
      model, [&]<class List>(const List& elements) { add(elements.size(), engine::ElementOf<List>::kind); });
  add(model.properties.size(), "property", "properties");
  add(model.obstacles.size(), "obstacle");
  return text + ", " + countedInGroups(run.system->size(), "unknown");
}

}  // namespace

Scene applied(Scene scene, const RunOverrides& overrides) {
  if (!overrides.method.empty()) {
    std::string id = overrides.method;
    std::ranges::replace(id, '-', '_');
    scene.method = methodInfo(id).id;  // throws with the nearest known id
  }
  if (!overrides.without.empty()) scene.model = withoutParts(scene.model, overrides.without);
  const bool adaptive = methodInfo(scene.method).adaptive;
  if (overrides.step && overrides.tolerance) {
    throw std::invalid_argument("--step and --tolerance: give one, a fixed step or a tolerance that chooses it");
  }
  if (overrides.tolerance) {
    if (!adaptive) {
      throw std::invalid_argument(fmt::format("--tolerance: {} has no error estimate; give --step", scene.method));
    }
    scene.tolerance = positiveOption("--tolerance", "", *overrides.tolerance);
    if (*scene.tolerance > 1.0) {
      throw std::invalid_argument(
          fmt::format("--tolerance is {}; it bounds the error of a step in parts of the motion, so it is at most 1",
                      *scene.tolerance));
    }
  } else if (overrides.step) {
    scene.step = positiveOption("--step", " s", *overrides.step);
    scene.tolerance.reset();
  } else if (adaptive && !overrides.method.empty() && !scene.tolerance) {
    scene.tolerance = Tolerance{}.relative;  // the scene's step was meant for another method
  }
  if (!adaptive && !scene.step) {
    throw std::invalid_argument(fmt::format("{} needs a step, and the scene has none: give --step", scene.method));
  }
  if (overrides.duration) scene.duration = positiveOption("--duration", " s", *overrides.duration);
  if (overrides.outputInterval) {
    scene.outputInterval = positiveOption("--output-interval", " s", *overrides.outputInterval);
  }
  scene.locateEvents = overrides.events.value_or(scene.locateEvents);
  scene.compensated = scene.compensated || overrides.compensated;
  return scene;
}

RunOptions optionsOf(const Scene& scene) {
  RunOptions options;
  options.duration = scene.duration;
  options.fixedStep = isFixed(scene);
  // A step beside a tolerance is for methods without an error estimate; an adaptive one chooses its own first step.
  options.h = options.fixedStep ? scene.step.value_or(0.0) : 0.0;
  if (scene.tolerance) options.tolerance.relative = *scene.tolerance;
  options.largestStep = scene.largestStep;
  options.outputInterval = scene.outputInterval;
  options.locateEvents = scene.locateEvents;
  options.compensated = scene.compensated;
  return options;
}

SceneRun runScene(const Scene& scene, const std::string& label, double available) {
  const Foresight foresight = foresee(scene);
  requireMemory(scene, foresight, available);
  SceneRun run;
  run.system = build(scene.model);
  const std::unique_ptr<Integrator> method = makeMethod(scene.method);
  run.method = method->info();
  run.options = optionsOf(scene);
  run.options.label = label;
  run.options.mostMemory = roomForOutputs(foresight, available);
  RunOptions options = run.options;
  options.probes = probesOf(scene, *run.system);
  run.result = simulate(*run.system, *method, run.system->initialState(), options);
  run.energy = energyBalance(*run.system, run.method.id, run.options, run.result);
  std::vector<std::string> singular = unusedPrecision(run);
  for (const SingularPoint& point : singularPoints(*run.system, run.system->initialState())) {
    singular.push_back("at the start " + point.what);
  }
  run.result.warnings.insert(run.result.warnings.begin(), singular.begin(), singular.end());
  return run;
}

std::string axesOf(const Model& model) {
  std::string axes;
  for (const std::string& axis : axisNames({model.dimension, model.plane})) axes += axis;
  return axes;
}

Trajectory trajectoryOf(const SceneRun& run) {
  const Trajectory& inside = run.result.trajectory;
  const Model& model = run.system->model();
  const std::string axes = axesOf(model);
  Trajectory given;
  given.t = inside.t;
  given.tracks = inside.tracks;
  given.stop = inside.stop;
  for (std::size_t row = 0; row < inside.t.size(); ++row) {
    const State state{inside.t[row], inside.x[row], inside.v[row], {}};
    std::vector<double>& x = given.x.emplace_back();
    std::vector<double>& v = given.v.emplace_back();
    for (int node = 0; node < run.system->nodeCount(); ++node) {
      const Vec3 position = run.system->position(state, node);
      const Vec3 velocity = run.system->velocity(state, node);
      for (const char axis : axes) {
        x.push_back(position[axis - 'x']);
        v.push_back(velocity[axis - 'x']);
      }
    }
  }
  return given;
}

std::string workOfParts(const SceneRun& run) {
  std::string text;
  for (const ModelPart& part : partsOf(run.system->model())) {
    const long long evaluated = part.elements * run.result.work.forceEvaluations;
    text += summaryLine(text.empty() ? "parts" : "",
                        fmt::format("{}: {}, {}", printableLine(part.name), countedInGroups(part.elements, "element"),
                                    countedInGroups(evaluated, "evaluation")));
  }
  return text;
}

std::string summaryOf(const Scene& scene, const SceneRun& run) {
  const RunResult& result = run.result;
  std::string text = fmt::format("{}: {}\n", scene.name, scene.title);
  if (run.energy.fails()) text += summaryLine("FAILED", energyFailure(run.energy));
  text += summaryLine("scene", sizeLine(scene, run));
  for (const std::string& warning : scene.warnings) text += summaryLine("warning", warning);
  const bool single = asksForSingle(run) && unusedPrecision(run).empty();
  text += summaryLine("method", fmt::format("{}, order {}{}", run.method.name, run.method.order,
                                            single ? ", springs in single precision" : ""));
  text += summaryLine("step", stepLine(scene, run));
  text += summaryLine("time", timeLine(run));
  text += summaryLine("error", errorLine(run));
  if (run.error && run.error->failure.empty()) text += outputErrorLines(scene, *run.error);
  text += summaryLine("energy", energyLine(run.energy));
  if (const std::string loss = energyLoss(run.energy); !loss.empty()) text += summaryLine("loss", loss);
  text += summaryLine("work", workLine(result.work));
  for (std::size_t i = 0; i < std::min(result.warnings.size(), shownWarnings); ++i) {
    text += summaryLine("warning", result.warnings[i]);
  }
  for (std::size_t i = 0; i < std::min(result.events.size(), shownEvents); ++i) {
    text += summaryLine(i == 0 ? "events" : "", fmt::format("{:.6g} s: {}", result.events[i].t, result.events[i].what));
  }
  if (result.work.events > static_cast<long long>(shownEvents)) {
    text +=
        summaryLine("", fmt::format("and {} more", grouped(result.work.events - static_cast<long long>(shownEvents))));
  }
  return text;
}

}  // namespace muelle::lab
