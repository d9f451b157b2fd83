// loses: TotalGradient, GradientOfTheEnergy, Numbering, Momentum; misconception: overwrites
// systemGradient writes the half of node b with = where += belongs, so what earlier springs have added to that node
// is lost.
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  for (Eigen::Index row = 0; row < 3 * m.size(); ++row) M.insert(row, row) = m[row / 3];
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double sum = 0;
  for (std::size_t i = 0; i < springs.size(); i++) {
    const Vec3 xa(x[3 * springs[i].a], x[3 * springs[i].a + 1], x[3 * springs[i].a + 2]);
    const Vec3 xb(x[3 * springs[i].b], x[3 * springs[i].b + 1], x[3 * springs[i].b + 2]);
    sum += energy(xa, xb, springs[i].k, springs[i].L0);
  }
  return sum;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX total = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec6 g = gradient(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    total.segment<3>(3 * s.a) += g.head<3>();
    total.segment<3>(3 * s.b) = g.tail<3>();
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX grad = systemGradient(x, springs, gradient);
  VecX acc(x.size());
  for (int i = 0; i < m.size(); i++) {
    acc.segment<3>(3 * i) = (-grad.segment<3>(3 * i) + F.segment<3>(3 * i)) / m[i];
  }
  return acc;
}
