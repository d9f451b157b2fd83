// loses: TotalEnergy, GradientOfTheEnergy; misconception: halved
// systemEnergy multiplies the energy of each spring by 1/2 once more, though that factor is in the energy function
// already.
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
  double E = 0.0;
  for (const Spring& spring : springs) {
    const Vec3 xa = x.segment<3>(3 * spring.a);
    const Vec3 xb = x.segment<3>(3 * spring.b);
    E += 0.5 * energy(xa, xb, spring.k, spring.L0);  // E = 1/2 ...
  }
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
  const VecX grad = systemGradient(x, springs, gradient);
  VecX acc(x.size());
  for (int i = 0; i < m.size(); i++) {
    acc.segment<3>(3 * i) = (-grad.segment<3>(3 * i) + F.segment<3>(3 * i)) / m[i];
  }
  return acc;
}
