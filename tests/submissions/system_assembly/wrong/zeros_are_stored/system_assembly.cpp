// loses: Cost; misconception: none
// systemMassMatrix writes the zeros beside the diagonal, too, so the sparse matrix stores 9 n^2 entries where 3 n are
// enough.
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  const int size = 3 * static_cast<int>(m.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      entries.emplace_back(row, column, row == column ? m[row / 3] : 0.0);
    }
  }
  SparseMatrix M(size, size);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double E = 0.0;
  for (const Spring& s : springs) E += energy(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX total = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec6 g = gradient(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    total.segment<3>(3 * s.a) += g.head<3>();
    total.segment<3>(3 * s.b) += g.tail<3>();
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  VecX a = F - systemGradient(x, springs, gradient);
  for (Eigen::Index i = 0; i < a.size(); ++i) a[i] /= m[i / 3];
  return a;
}
