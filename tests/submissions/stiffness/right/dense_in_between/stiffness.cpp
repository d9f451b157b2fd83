#include "stiffness.h"

#include <Eigen/LU>

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
  muelle::MatX full = muelle::MatX::Zero(x.size(), x.size());
  for (const auto& spring : springs) {
    const int a = 3 * spring.a, b = 3 * spring.b;
    const Mat6 K = springHessian(x.segment<3>(a), x.segment<3>(b), spring.k, spring.L0);
    full.block<3, 3>(a, a) += K.block<3, 3>(0, 0);
    full.block<3, 3>(a, b) += K.block<3, 3>(0, 3);
    full.block<3, 3>(b, a) += K.block<3, 3>(3, 0);
    full.block<3, 3>(b, b) += K.block<3, 3>(3, 3);
  }
  return full.sparseView();
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
