#include "engine/model/few_springs.h"

#include "engine/kernels/loops/spring_force.h"

#include <utility>

namespace muelle::engine {

template <int D, bool relative, bool projected, bool crossing>
void FewSprings::sum(const FewSprings& self, const Configuration& at, const double* inverseMass, double* a) {
  const std::size_t count = self.weight_.size();
  const double* const weight = self.weight_.data();
  const kernels::SpringArrays s = self.springs_.arrays();
  for (std::size_t i = 0; i < count; ++i) a[i] = weight[i];
  for (std::size_t i = 0; i < s.count; ++i) {
    const int first = s.a[i], second = s.b[i];
    double d[D], w[D] = {}, F[D];
    for (int c = 0; c < D; ++c) d[c] = at.x[first + c] - at.x[second + c];
    if constexpr (relative || projected) {
      for (int c = 0; c < D; ++c) w[c] = at.v[first + c] - at.v[second + c];
    }
    if (crossing && at.z[i] != 0.0) {  // frozen on its side
      F[0] = s.k[i] * (at.z[i] * s.L0[i] - d[0]);
      if constexpr (relative) F[0] -= s.dRelative[i] * w[0];
    } else {
      kernels::springForce<D, relative, projected>(
          d, w, {s.k[i], s.L0[i], relative ? s.dRelative[i] : 0.0, projected ? s.dProjected[i] : 0.0}, F);
    }
    for (int c = 0; c < D; ++c) a[first + c] += F[c];
    for (int c = 0; c < D; ++c) a[second + c] -= F[c];
  }
  for (std::size_t i = 0; i < count; ++i) a[i] *= inverseMass[i];
}

template <int D>
FewSprings::Loop FewSprings::loopOf(kernels::Damping damping) {
  switch (damping) {
    case kernels::Damping::None:
      return sum<D, false, false>;
    case kernels::Damping::Relative:
      return sum<D, true, false>;
    case kernels::Damping::Projected:
      return sum<D, false, D != 1>;
    case kernels::Damping::Both:
      return sum<D, true, D != 1>;
  }
  return nullptr;
}

FewSprings::FewSprings(int dimension, kernels::SpringRun springs, bool crossing, std::vector<double> weight)
    : springs_(std::move(springs)), weight_(std::move(weight)) {
  if (crossing) {
    loop_ = springs_.damping == kernels::Damping::None ? sum<1, false, false, true> : sum<1, true, false, true>;
  } else {
    loop_ = dimension == 1   ? loopOf<1>(springs_.damping)
            : dimension == 2 ? loopOf<2>(springs_.damping)
                             : loopOf<3>(springs_.damping);
  }
}

}  // namespace muelle::engine
