// loses: TotalGradient, GradientOfTheEnergy; misconception: smaller_number_first
// the smaller number first
#include "system_assembly.h"

static Vec3 at(const VecX& x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); }

SparseMatrix systemMassMatrix(const VecX& m) {
  const Eigen::Index size = 3 * m.size();
  SparseMatrix mass(size, size);
  mass.reserve(Eigen::VectorXi::Constant(size, 1));
  for (Eigen::Index i = 0; i < m.size(); i++) {
    mass.insert(3 * i, 3 * i) = m(i);
    mass.insert(3 * i + 1, 3 * i + 1) = m(i);
    mass.insert(3 * i + 2, 3 * i + 2) = m(i);
  }
  mass.makeCompressed();
  return mass;
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
  for (const Spring& spring : springs) {
    const int i = std::min(spring.a, spring.b), j = std::max(spring.a, spring.b);
    const Vec6 g = gradient(at(x, i), at(x, j), spring.k, spring.L0);
    for (int c = 0; c < 3; c++) {
      result[3 * i + c] += g[c];
      result[3 * j + c] += g[3 + c];
    }
  }
  return result;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX slope = systemGradient(x, springs, gradient);
  VecX a(x.size());
  for (Eigen::Index i = 0; i < a.size(); i++) a[i] = (F[i] - slope[i]) / m[i / 3];
  return a;
}
