// loses: AssembleHessian; misconception: none
// assembleHessian puts the block of node a into the rows a, a+1, a+2 where 3a, 3a+1, 3a+2 belong.
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
  std::vector<Eigen::Triplet<double>> t;
  for (const Spring& s : springs) {
    const Mat6 H = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        t.emplace_back(s.a + i, s.a + j, H(i, j));
        t.emplace_back(s.a + i, s.b + j, H(i, j + 3));
        t.emplace_back(s.b + i, s.a + j, H(i + 3, j));
        t.emplace_back(s.b + i, s.b + j, H(i + 3, j + 3));
      }
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(t.begin(), t.end());
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
