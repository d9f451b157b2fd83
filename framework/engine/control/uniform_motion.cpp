#include "engine/control/uniform_motion.h"

namespace muelle::engine {

void uniformIncrement(const State& from, double h, In a, State& increment) {
  increment = from;
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    increment.x[i] = h * (from.v[i] + 0.5 * h * a[i]);
    increment.v[i] = h * a[i];
  }
}

void moveUniformly(const State& from, double h, In a, State& to) {
  uniformIncrement(from, h, a, to);
  to.t += h;
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    to.x[i] += from.x[i];
    to.v[i] += from.v[i];
  }
}

}  // namespace muelle::engine
