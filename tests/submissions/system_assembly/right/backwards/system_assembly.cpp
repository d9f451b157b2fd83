#include "system_assembly.h"

using Nodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;

static Nodes nodesOf(const VecX& x) { return Eigen::Map<const Nodes>(x.data(), 3, x.size() / 3); }
static VecX flat(const Nodes& nodes) { return Eigen::Map<const VecX>(nodes.data(), nodes.size()); }

SparseMatrix systemMassMatrix(const VecX& m) {
  const VecX all = m.transpose().replicate(3, 1).reshaped();
  SparseMatrix M(all.size(), all.size());
  for (Eigen::Index i = all.size(); i-- > 0;) M.insert(i, i) = all(i);
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double E = 0.0;
  for (auto s = springs.rbegin(); s != springs.rend(); ++s) {
    E += energy(x.segment(3 * s->a, 3), x.segment(3 * s->b, 3), s->k, s->L0);
  }
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX sum = VecX::Zero(x.size());
  for (auto s = springs.rbegin(); s != springs.rend(); ++s) {
    const Vec6 g = gradient(x.segment(3 * s->a, 3), x.segment(3 * s->b, 3), s->k, s->L0);
    for (int c = 2; c >= 0; --c) {
      sum[3 * s->a + c] += g[c];
      sum[3 * s->b + c] += g[c + 3];
    }
  }
  return sum;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const Nodes force = nodesOf(F - systemGradient(x, springs, gradient));
  return flat(force * m.cwiseInverse().asDiagonal());
}
