#include "harness/march.h"

#include "base/progress_bar.h"
#include "harness/run_monitor.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument("march: " + message);
}

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }

void checkOptions(const MarchOptions& options) {
  require(isPositive(options.h), fmt::format("the step h is {} s; it must be positive and finite", options.h));
  require(isPositive(options.duration),
          fmt::format("the duration is {} s; it must be positive and finite", options.duration));
  require(options.duration / options.h < 1e12,
          fmt::format("{} s in steps of {} s are too many steps", options.duration, options.h));
  require(options.outputEvery >= 1, fmt::format("outputEvery is {}; record every 1 step or more", options.outputEvery));
  require(options.explosion > 0.0, fmt::format("explosion is {}; it must be positive", options.explosion));
  require(options.dimension >= 0 && options.dimension <= 3,
          fmt::format("dimension is {}; a node has 1, 2 or 3 degrees of freedom (0: guess)", options.dimension));
  for (const Probe& probe : options.probes) {
    require(static_cast<bool>(probe.measure), "the probe '" + probe.name + "' has no function");
  }
}

void checkSizes(const DynamicalSystem& system, const State& start) {
  const auto size = static_cast<std::size_t>(system.size());
  require(size > 0, "the system has no degree of freedom");
  require(start.x.size() == size && start.v.size() == size,
          fmt::format("the state has {} positions and {} velocities, the system {} degrees of freedom", start.x.size(),
                      start.v.size(), size));
  const std::span<const double> mass = system.mass();
  require(mass.size() == size, fmt::format("{} masses for {} degrees of freedom", mass.size(), size));
  for (std::size_t i = 0; i < size; ++i) {
    require(isPositive(mass[i]), fmt::format("mass {} is {} kg; a mass is positive and finite", i, mass[i]));
  }
  require(std::isfinite(start.t), "the start time is not finite");
}

/// The steps of a run: all of length h but the last.
struct StepPlan {
  double t0;
  double h;
  double end;
  long long count;

  StepPlan(double start, const MarchOptions& options)
      : t0(start), h(options.h), end(start + options.duration), count(0) {
    // The division may round a whole number up; 1e-12 is far above its error (1e-16) and far below a step that matters.
    const double steps = std::ceil(options.duration / h * (1.0 - 1e-12));
    count = std::max(1LL, static_cast<long long>(steps));
  }
  double time(long long step) const { return step == count ? end : t0 + static_cast<double>(step) * h; }
  double length(long long step) const {
    if (step < count) return h;
    const double rest = (end - t0) - static_cast<double>(count - 1) * h;
    const bool isWhole = std::abs(rest - h) < 1e-9 * h;  // then use h itself: all steps alike to the last bit
    return isWhole ? h : rest;
  }
};

/// Collects the states and what the probes measure.
class Recorder {
 public:
  Recorder(const std::vector<Probe>& probes, long long expectedOutputs) : probes_(probes) {
    const auto outputs = static_cast<std::size_t>(std::min(expectedOutputs, 1'000'000LL));
    trajectory_.t.reserve(outputs);
    trajectory_.x.reserve(outputs);
    trajectory_.v.reserve(outputs);
    for (const Probe& probe : probes_) {
      trajectory_.tracks.push_back({probe.name, probe.unit, {}});
      trajectory_.tracks.back().values.reserve(outputs);
    }
  }

  void record(const State& state) {
    trajectory_.t.push_back(state.t);
    trajectory_.x.push_back(state.x);
    trajectory_.v.push_back(state.v);
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      trajectory_.tracks[i].values.push_back(probes_[i].measure(state));
    }
  }

  /// Records the state unless it is the one recorded last.
  void recordOnce(const State& state) {
    if (trajectory_.t.empty() || trajectory_.t.back() != state.t) record(state);
  }

  Trajectory finish(StopReport stop) {
    trajectory_.stop = std::move(stop);
    return std::move(trajectory_);
  }

 private:
  const std::vector<Probe>& probes_;
  Trajectory trajectory_;
};

}  // namespace

Trajectory march(const DynamicalSystem& system, State start, const MarchOptions& options, const Step& step) {
  checkOptions(options);
  checkSizes(system, start);
  const StepPlan plan(start.t, options);
  Recorder recorder(options.probes, plan.count / options.outputEvery + 2);
  RunMonitor monitor(system, options.explosion, options.duration, options.dimension);
  ProgressBar progress(options.label);

  State from = std::move(start);
  recorder.record(from);
  StopReport stop = monitor.checkStart(from);
  if (stop.stopped) return recorder.finish(std::move(stop));

  State to = from;
  for (long long i = 1; i <= plan.count; ++i) {
    step(system, from, plan.length(i), to);
    to.t = plan.time(i);  // not the running sum, whose rounding grows with the number of steps
    stop = monitor.checkStep(from, to);
    if (stop.stopped) {
      recorder.recordOnce(from);
      return recorder.finish(std::move(stop));
    }
    std::swap(from, to);
    if (i % options.outputEvery == 0 || i == plan.count) recorder.record(from);
    progress.update(static_cast<double>(i) / static_cast<double>(plan.count));
  }
  return recorder.finish({});
}

}  // namespace muelle
