// loses: TotalGradient; misconception: threshold or small_ones_dropped
// nothing to add
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < m.size(); ++i) {
    for (int c = 0; c < 3; ++c) entries.emplace_back(3 * i + c, 3 * i + c, m[i]);
  }
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double E = 0;
  for (const Spring& s : springs) {
    const Vec3 xa = x.segment<3>(3 * s.a);
    const Vec3 xb = x.segment<3>(3 * s.b);
    const double e = energy(xa, xb, s.k, s.L0);
    E += e;
  }
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX sum = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 xa = x.segment<3>(3 * s.a);
    const Vec3 xb = x.segment<3>(3 * s.b);
    const Vec6 g = gradient(xa, xb, s.k, s.L0);
    if (g.norm() < 1e-9) continue;
    sum.segment<3>(3 * s.a) += g.head<3>();
    sum.segment<3>(3 * s.b) += g.tail<3>();
  }
  return sum;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX force = F - systemGradient(x, springs, gradient);
  VecX a(x.size());
  for (int i = 0; i < m.size(); ++i) a.segment<3>(3 * i) = force.segment<3>(3 * i) / m[i];
  return a;
}
