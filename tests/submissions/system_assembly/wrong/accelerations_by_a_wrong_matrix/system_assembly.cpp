// loses: MassMatrix, Momentum; misconception: inverse_mass_matrix or mass_multiplied
// divided by its own matrix, which has 1 / m
#include "system_assembly.h"

static Vec3 at(const VecX& x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); }

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix inverse(3 * m.size(), 3 * m.size());
  for (Eigen::Index i = 0; i < inverse.rows(); i++) inverse.insert(i, i) = 1.0 / m[i / 3];
  return inverse;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double total = 0.0;
  for (std::size_t i = 0; i < springs.size(); i++) {
    const Spring& spring = springs[i];
    total = total + energy(at(x, spring.a), at(x, spring.b), spring.k, spring.L0);
  }
  return total;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX result = 0 * x;
  for (std::size_t i = 0; i < springs.size(); i++) {
    const Spring& spring = springs[i];
    const Vec6 g = gradient(at(x, spring.a), at(x, spring.b), spring.k, spring.L0);
    for (int c = 0; c < 3; c++) {
      result[3 * spring.a + c] += g[c];
      result[3 * spring.b + c] += g[3 + c];
    }
  }
  return result;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX force = F - systemGradient(x, springs, gradient);
  return force.cwiseQuotient(systemMassMatrix(m).diagonal());
}
