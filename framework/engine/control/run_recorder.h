#pragma once
#include "engine/control/simulate.h"
#include "engine/control/simulation.h"

namespace muelle::engine {

/// Collects the outputs of a run and what the probes measure there.
class RunRecorder {
 public:
  RunRecorder(const RunOptions& options, double start);

  void record(const State& state);
  /// Records the state unless it is the one recorded last.
  void recordOnce(const State& state);
  /// Records the outputs that lie inside the simulation's last step, by dense output, and its end when an output is due
  /// there or `asked` for.
  void recordStep(Simulation& simulation, bool asked);
  Trajectory finish(StopReport stop);
  /// One output in so many is kept, so that they fit into the memory that they may take; a power of 2.
  long long kept() const { return stride_; }

 private:
  /// The next output time; infinite when none is left, or when every step is recorded.
  double due() const;

  /// Records what is due inside the step; how many outputs its end is.
  int recordInside(Simulation& simulation);
  void append(const State& state);
  void thin();

  const RunOptions& options_;
  double start_;
  long long stride_ = 1;
  long long count_ = 0;  // of the outputs, recorded or not
  long long next_ = 1;   // the next multiple of the output interval, or sample time counted from 1
  Trajectory trajectory_;
};

}  // namespace muelle::engine
