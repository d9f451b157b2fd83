#include "engine/statics/cusp.h"

#include "engine/solve/linear_solver.h"

#include <cmath>
#include <limits>

namespace muelle::engine {

std::vector<int> nodesOnACusp(const DynamicalSystem& system, const State& state, double size) {
  using Vector = Eigen::VectorXd;
  const auto count = static_cast<std::size_t>(system.size());
  const Eigen::Index unknowns = system.size();
  const Eigen::Map<const Vector> x(state.x.data(), unknowns);
  const auto force = [&](const Vector& at) {
    Vector f(unknowns);
    system.potential()->conservativeForce(state.t, {at.data(), count}, state.z, {f.data(), count});
    return f;
  };
  // Directions without a pattern, so that no two neighbours move alike.
  Vector way(unknowns);
  for (Eigen::Index i = 0; i < unknowns; ++i) way[i] = std::sin(12.9898 * static_cast<double>(i) + 0.7);
  const Vector here = force(x);
  const Vector far = force(x + 1e-6 * size * way) - here;
  const Vector near = force(x + 1e-9 * size * way) - here;
  SystemMatrix K;
  const std::vector<double> rest(count, 0.0);
  // Beside the place, as at it the derivatives may be of any size.
  const Vector beside = x + 1e-6 * size * way;
  system.linearisation()->assemble(0.0, 0.0, 1.0, state.t, {beside.data(), count}, rest, state.z, Form::Symmetric, K);
  Vector bits;
  multiplyAbsolute(K, x, bits);
  bits *= std::numeric_limits<double>::epsilon();
  std::vector<int> nodes;
  const Eigen::Index dimension = system.dimension();
  for (Eigen::Index i = 0; i + dimension <= unknowns; i += dimension) {
    const double jump = near.segment(i, dimension).norm();
    const bool isJump = jump > 0.3 * far.segment(i, dimension).norm();
    if (isJump && jump > 1e3 * bits.segment(i, dimension).norm() && jump > 1e-290) {
      nodes.push_back(static_cast<int>(i / dimension));
    }
  }
  return nodes;
}

}  // namespace muelle::engine
