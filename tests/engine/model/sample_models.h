#pragma once
#include "engine/model/model_system.h"

#include <random>
#include <vector>

namespace muelle::engine::testing {

/// Numbers in [-1, 1], the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return 2.0 * static_cast<double>(engine_()) / static_cast<double>(engine_.max()) - 1.0; }
  Vec3 vector() {
    const double a = (*this)(), b = (*this)(), c = (*this)();
    return {a, b, c};
  }

 private:
  std::mt19937 engine_;
};

/// Six nodes about a unit apart, the third pinned, with different masses and velocities, and no force.
inline Model sixNodes(int dimension, unsigned seed) {
  Random random(seed);
  Model model;
  model.dimension = dimension;
  const Vec3 places[] = {{0, 0, 0}, {1.1, 0, 0.1}, {0.3, 1, 0.9}, {0.4, -0.2, -1}, {-0.8, 0.6, 0.3}, {1.7, 0.9, -0.6}};
  for (int i = 0; i < 6; ++i) {
    ModelNode node;
    node.x = places[i] + 0.15 * random.vector();
    if (dimension == 1) node.x[0] = 1.2 * i + 0.3 * random();
    node.v = random.vector();
    node.m = 1.0 + 0.3 * i;
    node.pinned = i == 2;
    model.nodes.push_back(node);
  }
  return model;
}

/// The force on every unknown.
inline std::vector<double> forceOf(const DynamicalSystem& system, const State& s) {
  std::vector<double> f(s.x.size());
  system.force(s.t, s.x, s.v, s.z, f);
  return f;
}

/// The direction of the height.
inline Vec3 up(int dimension) { return dimension == 1 ? Vec3::UnitX() : Vec3::UnitZ(); }

}  // namespace muelle::engine::testing
