#include "engine/model/few_springs.h"

#include "engine/kernels/loops/group_loop.h"

#include <utility>

namespace muelle::engine {

template <int D, bool relative, bool projected, bool crossing>
void FewSprings::sum(const FewSprings& self, const Configuration& at, const double* inverseMass, double* a) {
  const std::size_t count = self.weight_.size();
  const double* const weight = self.weight_.data();
  const kernels::SpringArrays s = self.springs_.arrays();
  for (std::size_t i = 0; i < count; ++i) a[i] = weight[i];
  for (std::size_t i = 0; i < s.count; ++i) {
    if (crossing && at.z[i] != 0.0) {  // frozen on its side
      double F = s.k[i] * (at.z[i] * s.L0[i] - (at.x[s.a[i]] - at.x[s.b[i]]));
      if constexpr (relative) F -= s.dRelative[i] * (at.v[s.a[i]] - at.v[s.b[i]]);
      a[s.a[i]] += F;
      a[s.b[i]] -= F;
    } else {
      kernels::addOneSpring<D, relative, projected>(s, i, at.x, at.v, a);
    }
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
