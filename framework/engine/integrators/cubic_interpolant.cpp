#include "engine/integrators/cubic_interpolant.h"

namespace muelle::engine {

void interpolateByVelocities(const State& from, const State& to, double theta, State& out) {
  const double h = to.t - from.t;
  out.t = from.t + theta * h;
  out.x.resize(from.x.size());
  out.v.resize(from.x.size());
  out.z = from.z;
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    const double d = to.x[i] - from.x[i], v0 = h * from.v[i], v1 = h * to.v[i];
    const double c2 = 3.0 * d - 2.0 * v0 - v1, c3 = v0 + v1 - 2.0 * d;
    out.x[i] = cubic(theta, from.x[i], v0, to.x[i], v1);
    out.v[i] = (v0 + theta * (2.0 * c2 + 3.0 * theta * c3)) / h;
  }
}

}  // namespace muelle::engine
