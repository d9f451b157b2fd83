// loses: Accelerations; misconception: uphill
#include "system_assembly.h"

using Nodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;

static Nodes nodesOf(const VecX& x) { return Eigen::Map<const Nodes>(x.data(), 3, x.size() / 3); }
static VecX flat(const Nodes& nodes) { return Eigen::Map<const VecX>(nodes.data(), nodes.size()); }

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setIdentity();
  for (Eigen::Index i = 0; i < M.rows(); ++i) M.coeffRef(i, i) = m[i / 3];
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  const Nodes nodes = nodesOf(x);
  double sum = 0.0;
  for (const auto& [a, b, k, L0] : springs) sum += energy(nodes.col(a), nodes.col(b), k, L0);
  return sum;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  const Nodes nodes = nodesOf(x);
  Nodes sum = Nodes::Zero(3, nodes.cols());
  for (const auto& [a, b, k, L0] : springs) {
    const Vec6 g = gradient(nodes.col(a), nodes.col(b), k, L0);
    sum.col(a) += g.head<3>();
    sum.col(b) += g.tail<3>();
  }
  return flat(sum);
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const Nodes force = nodesOf(F + systemGradient(x, springs, gradient));
  return flat(force * m.cwiseInverse().asDiagonal());
}
