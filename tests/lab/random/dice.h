#pragma once
#include "harness/types.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace muelle::lab {

/// Random numbers of a seed.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }
  double logarithmic(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }
  /// A vector with components in (-size, size) along the axes of a scene: x in 1D, x and z in 2D.
  Vec3 vector(int dimension, double size) {
    Vec3 v = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const bool has = dimension == 3 || (dimension == 1 ? axis == 0 : axis != 1);
      if (has) v[axis] = uniform(-size, size);
    }
    return v;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace muelle::lab
