// loses: BackwardEuler, Indefinite, Order, NumericalDamping, Stability, Momentum; misconception: zero
#include "stiffness.h"

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double r[3] = {xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]};
  const double L = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double same = i == j ? 1.0 : 0.0;
      double A = k * same;
      if (L > 0) {
        const double nn = r[i] / L * (r[j] / L);
        A = k * nn + k * (L - L0) / L * (same - nn);
      }
      K(i, j) = A;
      K(i, j + 3) = -A;
      K(i + 3, j) = -A;
      K(i + 3, j + 3) = A;
    }
  }
  return K;
}

namespace {

Vec3 node(const VecX& x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); }

}  // namespace

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  SparseMatrix result(x.size(), x.size());
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(node(x, s.a), node(x, s.b), s.k, s.L0);
    const int start[2] = {3 * s.a, 3 * s.b};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) result.coeffRef(start[i / 3] + i % 3, start[j / 3] + j % 3) += K(i, j);
    }
  }
  return result;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const int a = 3 * s.a, b = 3 * s.b;
    const double r[3] = {x[a] - x[b], x[a + 1] - x[b + 1], x[a + 2] - x[b + 2]};
    const double L = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    if (L == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const double onA = -s.k * (L - s.L0) / L * r[c];
      F[a + c] += onA;
      F[b + c] -= onA;
    }
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  (void)m, (void)springs, (void)F, (void)h;
  return {VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}
