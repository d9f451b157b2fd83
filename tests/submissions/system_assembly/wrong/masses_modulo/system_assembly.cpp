// loses: MassMatrix; misconception: masses_interleaved
// systemMassMatrix gives row r the mass number r % n where it should be r / 3: the masses of all nodes come one after
// the other, three times over.
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  const auto n = m.size();
  SparseMatrix M(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < 3 * n; i++) M.insert(i, i) = m[i % n];
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
  VecX sum = VecX::Zero(x.size());
  for (const auto& [a, b, k, L0] : springs) {
    const Vec3 xa = x.segment(3 * a, 3);
    const Vec3 xb = x.segment(3 * b, 3);
    const Vec6 g = gradient(xa, xb, k, L0);
    for (int c = 0; c < 3; c++) {
      sum[3 * a + c] += g[c];
      sum[3 * b + c] += g[c + 3];
    }
  }
  return sum;
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
