#include "engine/kernels/fixed_window.h"

#include "engine/kernels/kernel_table.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine::kernels {

namespace {

constexpr int bits = 30;  // of the farthest coordinate: the difference of two has one more, and a sign
constexpr double smallest = 1e-8;
constexpr std::size_t line = 16;         // integers
constexpr std::size_t windowsApart = 4;  // of what a block looks at, between two moves to the front

}  // namespace

FixedWindow::FixedWindow(int dimension, std::size_t reach)
    : dimension_(static_cast<std::size_t>(dimension)),
      reach_((reach + line - 1) / line * line),
      plane_(windowsApart * reach_ + 9 * line),
      memory_(dimension_ * plane_ + line, 0) {
  const auto address = reinterpret_cast<std::uintptr_t>(memory_.data()) / sizeof(std::int32_t);
  start_ = (line - address % line) % line;
  setExponent(0);
}

void FixedWindow::setExponent(int exponent) {
  exponent_ = exponent;
  unit_ = std::ldexp(1.0F, exponent - bits);
}

void FixedWindow::begin(const double* values, std::size_t plane, std::size_t nodes) {
  values_ = values;
  valuesPlane_ = plane;
  nodes_ = nodes;
  first_ = end_ = 0;
  farthest_ = 0.0;
}

const std::int32_t* FixedWindow::from(std::size_t first) {
  const std::size_t need = std::min(first + reach_, nodes_);
  if (need > end_) {
    if (need - first_ > windowsApart * reach_) {
      for (std::size_t c = 0; c < dimension_; ++c) {
        std::int32_t* plane = memory_.data() + start_ + c * plane_;
        std::copy(plane + (first - first_), plane + (end_ - first_), plane);
      }
      first_ = first;
    }
    for (std::size_t c = 0; c < dimension_; ++c) {
      const double* values = values_ + c * valuesPlane_;
      const double far = kernels().toFixed(values + end_, *values, std::ldexp(1.0, bits - exponent_), need - end_,
                                           memory_.data() + start_ + c * plane_ + (end_ - first_));
      farthest_ = far > farthest_ || !(far >= 0.0) ? far : farthest_;  // what is no number is kept
    }
    end_ = need;
  }
  return memory_.data() + start_ + (first - first_);
}

FixedWindow::Verdict FixedWindow::verdict() {
  if (farthest_ == 0.0) return Verdict::Right;  // all in one place: any unit does
  if (!(farthest_ >= smallest && farthest_ <= largest)) return Verdict::OutOfRange;
  int exponent = 0;
  std::frexp(farthest_, &exponent);  // farthest < 2^exponent
  if (exponent == exponent_) return Verdict::Right;
  setExponent(exponent);
  return Verdict::OtherUnit;
}

}  // namespace muelle::engine::kernels
