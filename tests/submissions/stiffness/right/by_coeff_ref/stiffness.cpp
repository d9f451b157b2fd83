#include "stiffness.h"

#include <Eigen/SparseLU>

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
  SparseMatrix K(x.size(), x.size());
  for (const Spring& s : springs) {
    const Mat3 A = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0).topLeftCorner<3, 3>();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        K.coeffRef(3 * s.a + i, 3 * s.a + j) += A(i, j);
        K.coeffRef(3 * s.b + i, 3 * s.b + j) += A(i, j);
        K.coeffRef(3 * s.a + i, 3 * s.b + j) -= A(i, j);
        K.coeffRef(3 * s.b + i, 3 * s.a + j) -= A(i, j);
      }
    }
  }
  return K;
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

// For the new velocity itself: (M + h^2 K) v1 = M v + h F_total.
State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  SparseMatrix system = h * h * assembleHessian(now.x, springs);
  VecX right = h * (elasticForce(now.x, springs) + F);
  for (int node = 0; node < m.size(); ++node) {
    for (int c = 3 * node; c < 3 * node + 3; ++c) {
      system.coeffRef(c, c) += m[node];
      right[c] += m[node] * now.v[c];
    }
  }
  system.makeCompressed();
  Eigen::SparseLU<SparseMatrix> lu;
  lu.compute(system);
  const VecX v = lu.solve(right);
  return State{now.x + h * v, v};
}
