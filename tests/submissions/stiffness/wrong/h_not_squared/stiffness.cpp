// loses: BackwardEuler, NumericalDamping, Stability; misconception: step_not_squared
// backwardEulerStep has M + h K as its matrix where M + h^2 K belongs.
#include "stiffness.h"

#include <Eigen/SparseLU>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double L = (xa - xb).norm();
  const Mat3 I = Mat3::Identity();
  Mat3 A;
  if (L == 0) {
    A = k * I;
  } else {
    const Vec3 n = (xa - xb) / L;
    const double T = k * (L - L0);
    const Mat3 material = k * n * n.transpose();
    const Mat3 geometric = T / L * (I - n * n.transpose());
    A = material + geometric;
  }
  Mat6 K;
  K.block<3, 3>(0, 0) = A;
  K.block<3, 3>(0, 3) = -A;
  K.block<3, 3>(3, 0) = -A;
  K.block<3, 3>(3, 3) = A;
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
  VecX total = VecX::Zero(x.size());
  for (std::size_t i = 0; i < springs.size(); i++) {
    const auto& [a, b, k, L0] = springs[i];
    const Vec3 xa = x.segment<3>(3 * a);
    const Vec3 xb = x.segment<3>(3 * b);
    const double L = (xa - xb).norm();
    if (L > 0) {
      const Vec3 direction = (xa - xb) / L;
      total.segment<3>(3 * a) += -k * (L - L0) * direction;
      total.segment<3>(3 * b) += k * (L - L0) * direction;
    }
  }
  return total;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  SparseMatrix A = h * K;
  for (Eigen::Index i = 0; i < now.x.size(); ++i) A.coeffRef(i, i) += m[i / 3];
  A.makeCompressed();
  const VecX Kv = K * now.v;
  const VecX right = h * (elasticForce(now.x, springs) + F - h * Kv);
  Eigen::SparseLU<SparseMatrix> solver(A);
  const VecX v1 = now.v + solver.solve(right);
  return {now.x + h * v1, v1};
}
