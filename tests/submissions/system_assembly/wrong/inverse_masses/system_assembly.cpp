// loses: MassMatrix; misconception: inverse_mass_matrix
// systemMassMatrix holds the inverse masses, as one would need for the accelerations.
#include "system_assembly.h"

using Triplets = std::vector<Eigen::Triplet<double>>;

SparseMatrix systemMassMatrix(const VecX& m) {
  const int n = static_cast<int>(m.size());
  Triplets entries;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 3; ++j) entries.emplace_back(3 * i + j, 3 * i + j, 1.0 / m[i]);
  }
  SparseMatrix M(3 * n, 3 * n);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double sum = 0.0;
  for (auto s = springs.begin(); s != springs.end(); ++s) {
    const Vec3 xa = x.segment<3>(3 * s->a);
    const Vec3 xb = x.segment<3>(3 * s->b);
    sum += energy(xa, xb, s->k, s->L0);
  }
  return sum;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  Triplets entries;
  for (const Spring& s : springs) {
    const Vec3 xa = x.segment<3>(3 * s.a);
    const Vec3 xb = x.segment<3>(3 * s.b);
    const Vec6 g = gradient(xa, xb, s.k, s.L0);
    for (int j = 0; j < 3; ++j) {
      entries.emplace_back(3 * s.a + j, 0, g[j]);
      entries.emplace_back(3 * s.b + j, 0, g[3 + j]);
    }
  }
  SparseMatrix column(x.size(), 1);
  column.setFromTriplets(entries.begin(), entries.end());
  VecX total = VecX::Zero(x.size());
  for (SparseMatrix::InnerIterator it(column, 0); it; ++it) total[it.row()] = it.value();
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX total = F - systemGradient(x, springs, gradient);
  VecX acceleration(x.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    acceleration.segment<3>(3 * i) = total.segment<3>(3 * i) / m[i];
  }
  return acceleration;
}
