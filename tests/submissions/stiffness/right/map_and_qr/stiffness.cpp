#include "stiffness.h"

#include <Eigen/QR>
#include <map>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  Mat3 A = k * Mat3::Identity();
  if (L > 0) {
    const Vec3 n = r / L;
    const Mat3 along = n * n.transpose();
    const Mat3 across = Mat3::Identity() - along;
    A = k * along + k * (L - L0) / L * across;
  }
  Mat6 K;
  K << A, -A, -A, A;
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::map<std::pair<int, int>, double> entries;
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(x.segment(3 * s.a, 3), x.segment(3 * s.b, 3), s.k, s.L0);
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        const int row = 3 * (i < 3 ? s.a : s.b) + i % 3;
        const int col = 3 * (j < 3 ? s.a : s.b) + j % 3;
        entries[{row, col}] += K(i, j);
      }
    }
  }
  SparseMatrix result(x.size(), x.size());
  for (const auto& [place, value] : entries) result.insert(place.first, place.second) = value;
  return result;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 r = x.segment<3>(3 * s.a) - x.segment<3>(3 * s.b);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 onA = -s.k * (L - s.L0) / L * r;
    F.segment<3>(3 * s.a) += onA;
    F.segment<3>(3 * s.b) -= onA;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  VecX masses(now.x.size());
  for (int node = 0; node < m.size(); ++node) masses.segment(3 * node, 3).setConstant(m[node]);
  muelle::MatX A = muelle::MatX(K) * (h * h);
  A.diagonal() += masses;
  // QR takes any regular matrix.
  const VecX dv = A.householderQr().solve(h * elasticForce(now.x, springs) + h * F - h * h * (K * now.v));
  const VecX v = now.v + dv;
  return {now.x + h * v, v};
}
