#include "stiffness.h"

#include <Eigen/LU>

// d^2 E / dx_i dx_j = k [ (1 - L0/L) delta_ij + L0/L n_i n_j ]
Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double r[3], L = 0;
  for (int i = 0; i < 3; ++i) {
    r[i] = xa[i] - xb[i];
    L = std::hypot(L, r[i]);
  }
  Mat6 K;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      double entry = i % 3 == j % 3 ? k : 0.0;
      if (L > 0) {
        if (i % 3 == j % 3) entry -= k * (L0 / L);
        entry += k * (L0 / L) * (r[i % 3] / L) * (r[j % 3] / L);
      }
      K(i, j) = (i < 3) == (j < 3) ? entry : -entry;
    }
  }
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<Eigen::Triplet<double>> list;
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const int start[2] = {3 * s.a, 3 * s.b};
    for (int p = 0; p < 2; ++p) {
      for (int q = 0; q < 2; ++q) {
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) list.emplace_back(start[p] + i, start[q] + j, K(3 * p + i, 3 * q + j));
        }
      }
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(list.begin(), list.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<double> f(static_cast<std::size_t>(x.size()), 0.0);
  for (const Spring& s : springs) {
    const double dx = x[3 * s.b] - x[3 * s.a];
    const double dy = x[3 * s.b + 1] - x[3 * s.a + 1];
    const double dz = x[3 * s.b + 2] - x[3 * s.a + 2];
    const double L = std::sqrt(dx * dx + dy * dy + dz * dz);
    if (L > 0) {
      const double pull = s.k * (L - s.L0);
      const double part[3] = {pull * (dx / L), pull * (dy / L), pull * (dz / L)};
      for (int c = 0; c < 3; ++c) {
        f[static_cast<std::size_t>(3 * s.a + c)] += part[c];
        f[static_cast<std::size_t>(3 * s.b + c)] -= part[c];
      }
    }
  }
  return Eigen::Map<const VecX>(f.data(), x.size());
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const muelle::MatX K = assembleHessian(now.x, springs);
  muelle::MatX A = h * h * K;
  for (int i = 0; i < now.x.size(); ++i) A(i, i) += m[i / 3];
  const VecX b = h * (elasticForce(now.x, springs) + F - h * (K * now.v));
  const VecX dv = A.partialPivLu().solve(b);
  State next;
  next.v = now.v + dv;
  next.x = now.x + h * next.v;
  return next;
}
