// loses: ZeroLength; misconception: none
// elasticForce returns as soon as it meets a spring whose nodes coincide, so all springs after that one are left out.
#include "stiffness.h"

#include <Eigen/SparseLU>

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
  std::vector<Eigen::Triplet<double>> t;
  for (const Spring& s : springs) {
    const Mat6 H = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        t.emplace_back(3 * s.a + i, 3 * s.a + j, H(i, j));
        t.emplace_back(3 * s.a + i, 3 * s.b + j, H(i, j + 3));
        t.emplace_back(3 * s.b + i, 3 * s.a + j, H(i + 3, j));
        t.emplace_back(3 * s.b + i, 3 * s.b + j, H(i + 3, j + 3));
      }
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(t.begin(), t.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 d = x.segment<3>(3 * s.a) - x.segment<3>(3 * s.b);
    const double L = d.norm();
    if (L == 0) return F;  // no direction, no force
    const Vec3 f = s.k * (L - s.L0) * d / L;
    F.segment<3>(3 * s.a) -= f;
    F.segment<3>(3 * s.b) += f;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const int size = static_cast<int>(now.x.size());
  const SparseMatrix K = assembleHessian(now.x, springs);
  std::vector<Eigen::Triplet<double>> masses;
  for (int node = 0; node < m.size(); node++) {
    for (int c = 0; c < 3; c++) masses.emplace_back(3 * node + c, 3 * node + c, m[node]);
  }
  SparseMatrix A(size, size);
  A.setFromTriplets(masses.begin(), masses.end());
  A += h * h * K;
  const VecX total = elasticForce(now.x, springs) + F;
  VecX b = K * now.v;
  b = h * (total - h * b);
  Eigen::SparseLU<SparseMatrix> lu;
  lu.compute(A);
  const VecX dv = lu.solve(b);
  const VecX v1 = now.v + dv;
  return {now.x + h * v1, v1};
}
