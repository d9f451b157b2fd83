#include "engine/control/run_recorder.h"

#include "engine/control/step_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muelle::engine {

RunRecorder::RunRecorder(const RunOptions& options, double start) : options_(options), start_(start) {
  for (const Probe& probe : options.probes) trajectory_.tracks.push_back({probe.name, probe.unit, {}});
}

void RunRecorder::record(const State& state) {
  if (!options_.keepStates) {
    trajectory_.t.clear();
    trajectory_.x.clear();
    trajectory_.v.clear();
    for (Track& track : trajectory_.tracks) track.values.clear();
  } else if (count_++ % stride_ != 0) {
    return;
  }
  append(state);
  const double row = 2.0 * sizeof(double) * static_cast<double>(state.x.size()) + 64.0;
  const double most = std::max(1000.0, options_.mostMemory / row);
  if (options_.sampleTimes.empty() && static_cast<double>(trajectory_.t.size()) > most) thin();
}

/// Drops every second output but the first, now and from now on.
void RunRecorder::thin() {
  const auto halve = [](auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 2) std::swap(values[kept++], values[i]);
    values.resize(kept);
  };
  halve(trajectory_.t);
  halve(trajectory_.x);
  halve(trajectory_.v);
  for (Track& track : trajectory_.tracks) halve(track.values);
  stride_ *= 2;
}

void RunRecorder::append(const State& state) {
  trajectory_.t.push_back(state.t);
  trajectory_.x.push_back(state.x);
  trajectory_.v.push_back(state.v);
  for (std::size_t i = 0; i < options_.probes.size(); ++i) {
    trajectory_.tracks[i].values.push_back(options_.probes[i].measure(state));
  }
}

void RunRecorder::recordOnce(const State& state) {
  if (trajectory_.t.empty() || trajectory_.t.back() != state.t) append(state);
}

double RunRecorder::due() const {
  const std::vector<double>& samples = options_.sampleTimes;
  if (samples.empty()) return start_ + static_cast<double>(next_) * options_.outputInterval;
  const auto index = static_cast<std::size_t>(next_ - 1);
  return index < samples.size() ? samples[index] : std::numeric_limits<double>::infinity();
}

int RunRecorder::recordInside(Simulation& simulation) {
  if (options_.outputInterval == 0.0 && options_.sampleTimes.empty()) return 1;
  const double begin = simulation.stepBegin(), end = simulation.time();
  const double near = 1e-9 * (end - begin) + timeRounding(begin, end);  // then the step's end itself is the output
  int dueAtEnd = 0;
  for (; due() <= end + near; ++next_) {
    if (due() >= end - near) {
      ++dueAtEnd;
    } else {
      record(simulation.at(due()));
    }
  }
  return dueAtEnd;
}

void RunRecorder::recordStep(Simulation& simulation, bool asked) {
  // Sample times that differ by rounding, as those of another run may, are each an output of its own.
  for (int i = std::max(recordInside(simulation), asked ? 1 : 0); i > 0; --i) record(simulation.state());
}

Trajectory RunRecorder::finish(StopReport stop) {
  trajectory_.stop = std::move(stop);
  return std::move(trajectory_);
}

}  // namespace muelle::engine
