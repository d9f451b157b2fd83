#include "engine/control/simulate.h"

#include "base/progress_bar.h"
#include "engine/control/run_checks.h"
#include "engine/control/run_recorder.h"
#include "engine/control/simulation.h"
#include "engine/control/stability_looks.h"

#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include <utility>

namespace muelle::engine {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// What is left of the run beside its trajectory and its times.
void takeOver(const Simulation& simulation, RunResult& result) {
  result.last = simulation.state();
  result.work = simulation.work();
  result.warnings.insert(result.warnings.end(), simulation.warnings().begin(), simulation.warnings().end());
  result.events = simulation.events();
  result.subdividedSteps = simulation.subdividedSteps();
  result.smallestStep = std::isfinite(simulation.smallestStep()) ? simulation.smallestStep() : 0.0;
}

}  // namespace

RunResult simulate(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options) {
  if (start.z.empty()) start.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  RunResult result;
  auto begun = Clock::now();
  StabilityLooks looks(system, method.info(), options);
  const StepOptions& stepping = options;
  Simulation simulation(system, method, start, stepping);
  checkOutputOptions(options, start);
  if (looks.wanted() && !simulation.stop().stopped) {
    begun = Clock::now();
    simulation.lendMethod([&](Integrator& lent) { result.warnings = looks.before(lent, start); });
    result.checkTime = secondsSince(begun);
    begun = Clock::now();
  }
  ProgressBar progress(options.label);
  RunRecorder recorder(options, start.t);
  double lateLooks = 0.0;  // [s]
  recorder.record(simulation.state());
  for (Advance step = simulation.advance(); step.goesOn(); step = simulation.advance()) {
    if (step.kind == Advance::Kind::Step) recorder.recordStep(simulation, step.atOutput);
    if (step.hasJumped) {
      const auto looked = Clock::now();
      if (std::string warning = looks.afterSwitch(simulation.state()); !warning.empty()) simulation.warn(warning);
      lateLooks += secondsSince(looked);
    }
    progress.update((simulation.time() - start.t) / options.duration);
  }
  recorder.recordOnce(simulation.state());
  if (recorder.kept() > 1) {
    simulation.warn(fmt::format("the outputs would take more than {:.0f} MiB: every {}th is kept",
                                options.mostMemory / (1024.0 * 1024.0), recorder.kept()));
  }
  result.trajectory = recorder.finish(simulation.stop());
  takeOver(simulation, result);
  result.wallTime = secondsSince(begun) - lateLooks;
  result.checkTime += lateLooks;
  return result;
}

}  // namespace muelle::engine
