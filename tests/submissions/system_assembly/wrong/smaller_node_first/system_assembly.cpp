// loses: TotalGradient, GradientOfTheEnergy; misconception: smaller_number_first
// systemGradient takes the node with the smaller number for the first one of each spring, so a spring whose a is
// larger than b is asked with its ends exchanged.
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  for (Eigen::Index row = 0; row < 3 * m.size(); ++row) M.insert(row, row) = m[row / 3];
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
    const int a = std::min(s.a, s.b);
    const int b = std::max(s.a, s.b);
    const Vec6 g = gradient(x.segment<3>(3 * a), x.segment<3>(3 * b), s.k, s.L0);
    total.segment<3>(3 * a) += g.head<3>();
    total.segment<3>(3 * b) += g.tail<3>();
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  VecX a = F - systemGradient(x, springs, gradient);
  for (Eigen::Index i = 0; i < a.size(); ++i) a[i] /= m[i / 3];
  return a;
}
