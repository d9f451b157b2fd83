// loses: TotalEnergy, GradientOfTheEnergy; misconception: numbers_exchanged or swapped_arguments
// systemEnergy hands the rest length on for the stiffness and the stiffness for the rest length.
#include "system_assembly.h"

#include <numeric>

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic>;

static VecX threeTimes(const VecX& m) {
  Columns all(3, m.size());
  all.rowwise() = m.transpose();
  return Eigen::Map<const VecX>(all.data(), all.size());
}

SparseMatrix systemMassMatrix(const VecX& m) {
  const VecX diagonal = threeTimes(m);
  SparseMatrix M(diagonal.size(), diagonal.size());
  M = diagonal.asDiagonal();
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  const Eigen::Map<const Columns> X(x.data(), 3, x.size() / 3);
  return std::accumulate(springs.begin(), springs.end(), 0.0,
                         [&](double sum, const Spring& s) { return sum + energy(X.col(s.a), X.col(s.b), s.L0, s.k); });
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  const Eigen::Map<const Columns> X(x.data(), 3, x.size() / 3);
  VecX total = VecX::Zero(x.size());
  Eigen::Map<Columns> G(total.data(), 3, total.size() / 3);
  for (const auto& [a, b, k, L0] : springs) {
    const Vec6 g = gradient(X.col(a), X.col(b), k, L0);
    G.col(a) += g.head<3>();
    G.col(b) += g.tail<3>();
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX force = F - systemGradient(x, springs, gradient);
  return force.cwiseQuotient(threeTimes(m));
}
