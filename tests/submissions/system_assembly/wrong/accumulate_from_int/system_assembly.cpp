// loses: TotalEnergy, GradientOfTheEnergy; misconception: integer_division or whole_numbers
// systemEnergy starts std::accumulate with the int 0, so the sum is cut to a whole number after every spring.
#include "system_assembly.h"

#include <numeric>

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
  return std::accumulate(springs.begin(), springs.end(), 0, [&](double sum, const Spring& s) {
    return sum + energy(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
  });
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
