// loses: Accelerations; misconception: none
// systemAccelerations computes accelerations only for nodes that have a spring: a node without springs gets zero
// though other forces act on it.
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
    const Vec6 g = gradient(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    total.segment<3>(3 * s.a) += g.head<3>();
    total.segment<3>(3 * s.b) += g.tail<3>();
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX force = F - systemGradient(x, springs, gradient);
  VecX a = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    a.segment<3>(3 * s.a) = force.segment<3>(3 * s.a) / m[s.a];
    a.segment<3>(3 * s.b) = force.segment<3>(3 * s.b) / m[s.b];
  }
  return a;
}
