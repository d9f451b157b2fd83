// loses: Indefinite; misconception: never_written or cholesky
// backwardEulerStep solves by a Cholesky factorisation, which needs a positive definite matrix and fails where
// compressed springs make it indefinite.
#include "stiffness.h"

#include <Eigen/SparseCholesky>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 d = xa - xb;
  const double L = d.norm();
  Mat3 A = k * Mat3::Identity();
  if (L > 0) {
    const Vec3 n = d / L;
    const Mat3 along = n * n.transpose();
    A = k * along + k * (L - L0) / L * (Mat3::Identity() - along);
  }
  Mat6 K;
  K << A, -A, -A, A;
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const int start[2] = {3 * s.a, 3 * s.b};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) entries.emplace_back(start[i / 3] + i % 3, start[j / 3] + j % 3, K(i, j));
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 d = x.segment<3>(3 * s.a) - x.segment<3>(3 * s.b);
    const double L = d.norm();
    if (L == 0) continue;
    const Vec3 f = -s.k * (L - s.L0) * d / L;
    F.segment<3>(3 * s.a) += f;
    F.segment<3>(3 * s.b) -= f;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  SparseMatrix A = h * h * K;
  for (Eigen::Index i = 0; i < now.x.size(); ++i) A.coeffRef(i, i) += m[i / 3];
  A.makeCompressed();
  const VecX Kv = K * now.v;
  const VecX b = h * (elasticForce(now.x, springs) + F - h * Kv);
  Eigen::SimplicialLLT<SparseMatrix> cholesky(A);  // A is symmetric: half the work
  const VecX dv = cholesky.solve(b);
  State next;
  next.v = now.v + dv;
  next.x = now.x + h * next.v;
  return next;
}
