// loses: Accelerations; misconception: uphill or wrong_sign
// systemAccelerations adds the gradient to the other forces where it should be subtracted: the force of the springs
// is minus the gradient.
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
  const VecX forces = systemGradient(x, springs, gradient) + F;
  VecX a(forces.size());
  for (Eigen::Index i = 0; i < forces.size(); i++) a[i] = forces[i] / m[i / 3];
  return a;
}
