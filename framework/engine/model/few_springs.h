#pragma once
#include "engine/forces/configuration.h"
#include "engine/kernels/spring_run.h"
#include "harness/state.h"

#include <span>
#include <vector>

namespace muelle::engine {

/// The accelerations of a model of a few springs of one damping form, with gravity or without, and nothing else: one
/// function, for between several such a small force would spend most of its time. It is the same sum in the same order
/// as that of the batches, to the last bit.
class FewSprings {
 public:
  static constexpr std::size_t most = 8;  ///< springs, beyond which the kernels' loops win

  /// \param springs 1 ... most of them, on padded nodes
  /// \param crossing whether they are of 1D and may be followed through zero length, each by its internal variable, the
  ///        model's only ones
  /// \param weight [N] of each lane; 0 without gravity
  FewSprings(int dimension, kernels::SpringRun springs, bool crossing, std::vector<double> weight);

  /// Overwrites a, of as many lanes as there are weights.
  void accelerate(const Configuration& at, std::span<const double> inverseMass, Out a) const {
    loop_(*this, at, inverseMass.data(), a.data());
  }

 private:
  using Loop = void (*)(const FewSprings& self, const Configuration& at, const double* inverseMass, double* a);
  template <int D, bool relative, bool projected, bool crossing = false>
  static void sum(const FewSprings& self, const Configuration& at, const double* inverseMass, double* a);
  template <int D>
  static Loop loopOf(kernels::Damping damping);

  kernels::SpringRun springs_;
  std::vector<double> weight_;
  Loop loop_;
};

}  // namespace muelle::engine
