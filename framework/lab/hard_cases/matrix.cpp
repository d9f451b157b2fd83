#include "lab/hard_cases/matrix.h"

#include "base/text/nearest.h"
#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <set>
#include <stdexcept>

namespace muelle::hard_cases {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void refuseUnknown(const std::vector<std::string>& asked, const std::vector<std::string>& known, const char* what) {
  for (const std::string& name : asked) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw std::invalid_argument(fmt::format("no {} '{}'{}", what, name, suggestion(name, known)));
  }
}

engine::RunOptions optionsOf(const engine::MethodInfo& method, const Variant& variant) {
  engine::RunOptions options = method.adaptive ? withTolerance(variant.steps.toleranceOf(method), variant.duration)
                                               : fixedStep(variant.steps.of(method), variant.duration);
  options.explosion = 1e9;
  options.mostForceEvaluations = cellBudget;
  if (!method.adaptive) options.mostForceEvaluations *= 10;  // the number of steps is their bound
  return options;
}

/// H24 for one method: steps and states that must be refused. The number of those that were not.
double acceptedInputs(const std::string& method, const Variant& variant) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int accepted = 0;
  const auto system = engine::build(variant.model);
  const auto tryRun = [&](const State& start, const engine::RunOptions& options) {
    try {
      const engine::RunResult result = engine::simulate(*system, *engine::makeMethod(method), start, options);
      if (!result.failed()) ++accepted;
    } catch (const std::invalid_argument&) {
    }
  };
  for (const double h : {0.0, -0.01, nan}) {
    engine::RunOptions options = fixedStep(h, 1.0);
    tryRun(system->initialState(), options);
  }
  for (const double bad : {nan, infinite}) {
    State start = system->initialState();
    start.x[0] = bad;
    tryRun(start, fixedStep(0.01, 1.0));
    start = system->initialState();
    start.v[0] = bad;
    tryRun(start, fixedStep(0.01, 1.0));
  }
  return accepted;
}

void judge(Cell& cell, const Variant& variant) {
  const bool passes = cell.error <= variant.bar;
  cell.outcome = passes                                              ? Outcome::Passed
                 : cell.prediction.expectation == Expectation::Fails ? Outcome::FailedAsPredicted
                                                                     : Outcome::FailedUnexpectedly;
  cell.betterThanPredicted = cell.error < cell.prediction.error / surprisinglyGood;
}

}  // namespace

int Matrix::count(Outcome outcome) const {
  return static_cast<int>(std::ranges::count_if(cells, [=](const Cell& cell) { return cell.outcome == outcome; }));
}

int Matrix::betterThanPredicted() const {
  return static_cast<int>(std::ranges::count_if(cells, &Cell::betterThanPredicted));
}

const std::vector<KnownSurprise>& knownSurprises() {
  static const std::vector<KnownSurprise> known = {
      {"H01", "rkn64",
       "its steps are all alike but for 19 changes in 10,000 s: its error on an oscillator is then one of phase; of "
       "the forecast's, which are longer, a quarter differ from the one before, and the amplitude feels it"},
      {"H07 projected", "dop853",
       "its steps on a uniform rotation are all alike, and its local error there is one of phase; on the oscillator, "
       "from "
       "which the forecast is taken, the steps vary and the amplitude feels it"},
      {"H20 26.6", "rkc2",
       "the forecast holds the ground's mode at its limit of stability; the node is pressed in and balanced, nothing "
       "excites it, and the steps grow"},
      {"H20 26.6", "tr_bdf2",
       "the forecast resolves the ground's mode to the end; the node is pressed in and balanced, and there is nothing "
       "of it to resolve"}};
  return known;
}

std::string reasonOf(const Matrix& matrix, const Cell& cell) {
  for (const KnownSurprise& known : knownSurprises()) {
    if (known.method == cell.method && known.variant == matrix.variants[cell.variant].label()) return known.reason;
  }
  return "";
}

std::vector<const Cell*> unexplained(const Matrix& matrix) {
  std::vector<const Cell*> found;
  for (const Cell& cell : matrix.cells) {
    if (cell.betterThanPredicted && reasonOf(matrix, cell).empty()) found.push_back(&cell);
  }
  return found;
}

Matrix planMatrix(const MatrixOptions& options) {
  Matrix matrix;
  std::vector<std::string> ids;
  for (Variant& variant : allVariants()) {
    if (ids.empty() || ids.back() != variant.id) ids.push_back(variant.id);
    if (options.cases.empty() || std::ranges::find(options.cases, variant.id) != options.cases.end()) {
      matrix.variants.push_back(std::move(variant));
    }
  }
  refuseUnknown(options.cases, ids, "hard case");
  refuseUnknown(options.methods, engine::methodIds(), "method");
  matrix.methods = options.methods.empty() ? engine::methodIds() : options.methods;
  return matrix;
}

Cell runCell(const std::string& method, const Variant& variant) {
  const auto start = std::chrono::steady_clock::now();
  const engine::MethodInfo& info = engine::methodInfo(method);
  Cell cell;
  cell.method = method;
  cell.setting = variant.inputs  ? "h = 0, below 0, nan"
                 : info.adaptive ? fmt::format("tolerance {:.0e}", variant.steps.toleranceOf(info))
                                 : fmt::format("h = {:.4g} s", variant.steps.of(info));
  try {
    Finished end;
    end.system = engine::build(variant.model);
    const engine::RunOptions runOptions = optionsOf(info, variant);
    cell.prediction = predict(info, variant, *end.system, variant.duration, runOptions.mostForceEvaluations);
    if (variant.inputs) {
      cell.error = acceptedInputs(method, variant);
      judge(cell, variant);
    } else if (cell.prediction.expectation == Expectation::NotApplicable) {
      // It must say so itself, before the first step.
      try {
        engine::makeMethod(method)->prepare(*end.system, runOptions.tolerance);
        cell.note = "was expected to refuse the system, and did not";
      } catch (const std::invalid_argument& refusal) {
        cell.outcome = Outcome::NotApplicable;
        cell.note = refusal.what();
      }
    } else {
      const std::clock_t begun = std::clock();
      end.result = engine::simulate(*end.system, *engine::makeMethod(method), end.system->initialState(), runOptions);
      cell.processorSeconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
      cell.work = end.result.work;
      cell.error = end.result.failed() ? infinite : variant.error(end);
      if (!std::isfinite(cell.error)) cell.error = infinite;
      if (end.result.failed()) cell.note = end.result.trajectory.stop.message;
      judge(cell, variant);
    }
  } catch (const std::exception& error) {
    cell.error = infinite;
    cell.outcome = Outcome::FailedUnexpectedly;
    cell.note = error.what();
  }
  cell.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return cell;
}

void runMatrix(Matrix& matrix, const std::function<void(double)>& progress) {
  matrix.cells.clear();
  for (Variant& variant : matrix.variants) completeFacts(variant);
  const std::size_t all = matrix.methods.size() * matrix.variants.size();
  for (const std::string& method : matrix.methods) {
    for (std::size_t v = 0; v < matrix.variants.size(); ++v) {
      progress(static_cast<double>(matrix.cells.size()) / static_cast<double>(all));
      Cell cell = runCell(method, matrix.variants[v]);
      cell.variant = v;
      matrix.cells.push_back(std::move(cell));
    }
  }
}

}  // namespace muelle::hard_cases
