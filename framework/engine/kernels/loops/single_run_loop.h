#pragma once
/// \file
/// Springs i -> i + stride on nodes in planes, in single precision: see run_loop.h. Differences of positions are whole
/// numbers of a unit, exact, and of none the square leaves the range of a float.

#include "engine/kernels/kernel_arguments.h"

namespace muelle::engine::kernels {
namespace {

/// One spring in the place of a register of them: what is left over by whole registers.
struct SingleLane {
  using Vector = float;
  static Vector load(const float* p) { return *p; }
  static void store(float* p, Vector v) { *p = v; }
  static Vector all(float value) { return value; }
  static Vector root(Vector a) { return __builtin_sqrtf(a); }
  static Vector whereNotZero(Vector condition, Vector value) { return condition != 0.0F ? value : 0.0F; }
  static Vector difference(const std::int32_t* a, const std::int32_t* b) {
    const std::uint32_t apart =
        static_cast<std::uint32_t>(*a) - static_cast<std::uint32_t>(*b);  // modulo, as registers
    return static_cast<float>(static_cast<std::int32_t>(apart));
  }
};

/// A coefficient of the material, by the unit of what it is multiplied with: one register for all, or one read a step.
template <bool constant>
class SingleCoefficient {
 public:
  /// \param values null where the form has none
  SingleCoefficient(const float* values, float unit)
      : values_(values), unit_(unit), all_(constant && values ? *values * unit : 0.0F) {}
  template <class Register>
  typename Register::Vector at(std::size_t i) const {
    return constant ? Register::all(all_) : Register::load(values_ + i) * Register::all(unit_);
  }

 private:
  const float* values_;
  float unit_;
  float all_;
};

template <int D, bool relative, bool projected, bool constant>
class SingleRun {
 public:
  SingleRun(const SingleRunArrays& run, const FixedPlanes& at, const SinglePlanes& force)
      : k_(run.k, 1.0F), L0_(run.L0, 1.0F), dRelative_(run.dRelative, at.vUnit), dProjected_(run.dProjected, at.vUnit) {
    unit_ = at.xUnit;
    for (std::size_t c = 0; c < D; ++c) {
      x_[c] = at.x + c * at.plane;
      v_[c] = at.v + c * at.plane;
      out_[c] = force.data + c * force.plane;
    }
    stride_ = run.stride;
  }

  /// The forces on the nodes from i on, a register of them.
  template <class Lanes>
  void write(std::size_t i) const {
    using Vector = typename Lanes::Vector;
    Vector d[D], w[D];
    for (int c = 0; c < D; ++c) d[c] = Lanes::difference(x_[c] + i, x_[c] + i + stride_);
    if constexpr (relative || projected) {
      for (int c = 0; c < D; ++c) w[c] = Lanes::difference(v_[c] + i, v_[c] + i + stride_);
    }
    Vector square = d[0] * d[0];
    for (int c = 1; c < D; ++c) square += d[c] * d[c];
    const Vector L = Lanes::root(square);
    Vector ratio = k_.template at<Lanes>(i) * (L0_.template at<Lanes>(i) - L * Lanes::all(unit_));
    if constexpr (projected) {
      Vector speed = w[0] * d[0];
      for (int c = 1; c < D; ++c) speed += w[c] * d[c];
      const Vector inverse = Lanes::all(1.0F) / L;
      ratio = (ratio - dProjected_.template at<Lanes>(i) * (speed * inverse)) * inverse;
    } else {
      ratio = ratio / L;
    }
    ratio = Lanes::whereNotZero(square, ratio);
    for (int c = 0; c < D; ++c) {
      d[c] *= ratio;
      if constexpr (relative) d[c] -= dRelative_.template at<Lanes>(i) * w[c];
      Lanes::store(out_[c] + i, d[c]);
    }
  }

 private:
  SingleCoefficient<constant> k_, L0_, dRelative_, dProjected_;
  float unit_ = 1.0F;
  const std::int32_t *x_[D], *v_[D];
  float* out_[D];
  std::size_t stride_ = 1;
};

/// Writes the forces on `count` nodes by their springs. By value: a store could change what a reference leads to, as
/// far as the compiler knows.
template <class Lanes, int D, bool relative, bool projected, bool constant>
void forceOfRunSingle(const SingleRunArrays& run, const FixedPlanes& at, std::size_t count, const SinglePlanes& force) {
  const SingleRun<D, relative, projected, constant> springs(run, at, force);
  std::size_t i = 0;
  for (; i + Lanes::width <= count; i += Lanes::width) springs.template write<Lanes>(i);
  for (; i < count; ++i) springs.template write<SingleLane>(i);
}

}  // namespace
}  // namespace muelle::engine::kernels
