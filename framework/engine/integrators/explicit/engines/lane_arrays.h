#pragma once
#include "harness/state.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace muelle::engine {

/// Arrays of one number a lane, which a method owns: each begins a line of the cache, so that no register's load or
/// store spans two.
class LaneArrays {
 public:
  LaneArrays() = default;
  LaneArrays(LaneArrays&&) = default;  // no copy: begins_ points into memory_
  LaneArrays& operator=(LaneArrays&&) = default;

  /// `count` arrays of zeros.
  void assign(std::size_t count, std::size_t lanes) {
    constexpr std::size_t line = 8;
    const std::size_t stride = (lanes + line - 1) / line * line;
    lanes_ = lanes;
    memory_.assign(count * stride + line, 0.0);
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data()) / sizeof(double);
    double* const first = memory_.data() + (line - address % line) % line;
    begins_.resize(count);
    for (std::size_t j = 0; j < count; ++j) begins_[j] = first + stride * j;
  }

  std::size_t lanes() const { return lanes_; }
  double* data(std::size_t j) { return begins_[j]; }
  const double* data(std::size_t j) const { return begins_[j]; }
  Out operator[](std::size_t j) { return {begins_[j], lanes_}; }
  In operator[](std::size_t j) const { return {begins_[j], lanes_}; }
  void swap(std::size_t i, std::size_t j) { std::swap(begins_[i], begins_[j]); }
  /// Where each begins.
  const std::vector<double*>& begins() const { return begins_; }

 private:
  std::vector<double> memory_;
  std::vector<double*> begins_;
  std::size_t lanes_ = 0;
};

}  // namespace muelle::engine
