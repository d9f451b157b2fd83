// loses: BackwardEuler, Momentum; misconception: none
// backwardEulerStep multiplies the other forces F by the masses as if they were accelerations, but F is in newtons
// already.
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
  VecX total = elasticForce(now.x, springs);
  SparseMatrix M(now.x.size(), now.x.size());
  for (Eigen::Index i = 0; i < now.x.size(); ++i) {
    M.insert(i, i) = m[i / 3];
    total[i] += m[i / 3] * F[i];  // m g and so on
  }
  const SparseMatrix A = M + h * h * K;
  const VecX Kv = K * now.v;
  Eigen::SparseLU<SparseMatrix> solver(A);
  const VecX dv = solver.solve(h * (total - h * Kv));
  const VecX v = now.v + dv;
  return {now.x + h * v, v};
}
