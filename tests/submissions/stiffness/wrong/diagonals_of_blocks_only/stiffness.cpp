// loses: AssembleHessian; misconception: none
// assembleHessian takes only the diagonal of each 3 x 3 block: the entries that couple x, y and z are left out, so
// springs that are not along an axis are wrong.
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
  SparseMatrix K(x.size(), x.size());
  for (const Spring& s : springs) {
    const Mat6 H = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    for (int c = 0; c < 3; ++c) {
      const int a = 3 * s.a + c, b = 3 * s.b + c;
      K.coeffRef(a, a) += H(c, c);
      K.coeffRef(b, b) += H(c + 3, c + 3);
      K.coeffRef(a, b) += H(c, c + 3);
      K.coeffRef(b, a) += H(c + 3, c);
    }
  }
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
  SparseMatrix M(now.x.size(), now.x.size());
  for (Eigen::Index i = 0; i < now.x.size(); ++i) M.insert(i, i) = m[i / 3];
  const SparseMatrix system = M + h * h * K;
  const VecX Kv = K * now.v;
  const VecX right = h * (elasticForce(now.x, springs) + F - h * Kv);
  Eigen::SparseLU<SparseMatrix> solver(system);
  const VecX dv = solver.solve(right);
  State next;
  next.v = now.v + dv;
  next.x = now.x + h * next.v;
  return next;
}
