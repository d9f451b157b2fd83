#include "lab/run/tolerance_sweep.h"

#include "engine/control/motion_frame.h"
#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::lab {

using namespace engine;

Trajectory runAtTolerance(const ModelSystem& system, const std::string& method, double tolerance, double duration) {
  RunOptions options;
  options.duration = duration;
  options.tolerance.relative = tolerance;
  constexpr int outputs = 400;
  for (int i = 1; i <= outputs; ++i) options.sampleTimes.push_back(duration * i / outputs);
  const std::unique_ptr<Integrator> integrator = makeMethod(method);
  return simulate(system, *integrator, system.initialState(), options).trajectory;
}

double errorOver(const ModelSystem& system, const Trajectory& path, const Trajectory& exact) {
  if (path.stop.stopped) return std::numeric_limits<double>::infinity();
  MotionFrame frame(system, {0.0, exact.x[0], exact.v[0], {}});
  double size = 0.0, off = 0.0;
  for (std::size_t row = 0; row < exact.t.size(); ++row) {
    size = std::max(size, frame.sizeAt(system, {exact.t[row], exact.x[row], exact.v[row], {}}).position);
    for (std::size_t i = 0; i < exact.x[row].size(); ++i)
      off = std::max(off, std::abs(path.x[row][i] - exact.x[row][i]));
  }
  return off / size;
}

}  // namespace muelle::lab
