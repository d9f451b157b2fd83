// loses: Cost; misconception: none
// systemGradient asks the gradient of each spring twice, once for each half, where one answer serves both nodes.
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < m.size(); i++) {
    for (int c = 0; c < 3; c++) entries.push_back(Eigen::Triplet<double>(3 * i + c, 3 * i + c, m[i]));
  }
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setFromTriplets(entries.begin(), entries.end());
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
  for (const Spring& s : springs) {
    const Vec3 xa = x.segment<3>(3 * s.a), xb = x.segment<3>(3 * s.b);
    sum.segment<3>(3 * s.a) += gradient(xa, xb, s.k, s.L0).head<3>();
    sum.segment<3>(3 * s.b) += gradient(xa, xb, s.k, s.L0).tail<3>();
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
