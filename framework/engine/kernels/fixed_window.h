#pragma once
#include "engine/kernels/kernel_arguments.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace muelle::engine::kernels {

/// Vectors of nodes in planes as 32-bit integers, for forces in single precision: of those nodes that a block of a
/// sweep over a grid looks at, so that they stay in the cache. A coordinate is a whole number of units from that of the
/// first node, the unit a power of two such that the farthest coordinate has less than 2^30 of them: the difference of
/// two nodes is then exact, and off by 2^-30 of the scene's size at most, where differences of floats would be off by
/// 2^-24.
///
/// The unit is that of the last sweep, which mostly still is right; whether it was is known when all nodes were seen.
/// Who is told that it was not sweeps again: so the integers depend on the vectors alone, on nothing before.
class FixedWindow {
 public:
  /// The largest size [m] or [m/s]; a material no larger keeps every product within the range of a float.
  static constexpr double largest = 1e12;

  /// \param reach nodes behind a block's first that are looked at, the block included
  FixedWindow(int dimension, std::size_t reach);

  /// Begins a sweep over `nodes` nodes. \param values component c of node i at [c * plane + i]
  void begin(const double* values, std::size_t plane, std::size_t nodes);

  /// The integers of the nodes from `first` on, as far as it reaches: component c at [c * plane()]. Blocks ascend.
  const std::int32_t* from(std::size_t first);
  std::size_t plane() const { return plane_; }
  float unit() const { return unit_; }

  enum class Verdict {
    Right,
    OtherUnit,   ///< now it is the right one: once more
    OutOfRange,  ///< what is no finite number, or a size whose squares leave the range of a float
  };
  /// At the end of a sweep.
  Verdict verdict();

 private:
  void setExponent(int exponent);

  std::size_t dimension_, reach_, plane_;
  std::vector<std::int32_t> memory_;
  std::size_t start_ = 0;  ///< where it is at a multiple of 64 bytes
  const double* values_ = nullptr;
  std::size_t valuesPlane_ = 0, nodes_ = 0;
  std::size_t first_ = 0, end_ = 0;  ///< nodes that are there
  double farthest_ = 0.0;            ///< of those that were seen
  int exponent_ = 0;                 ///< 2^30 units are 2^this
  float unit_ = 1.0F;
};

}  // namespace muelle::engine::kernels
