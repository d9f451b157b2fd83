// loses: SpringHessian, GeometricPart, DerivativeOfForce; misconception: tension_not_over_length
// The geometric part has the tension itself, it is not divided by the length.
#include "stiffness.h"

#include <Eigen/Dense>

using muelle::MatX;

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Mat3 A;
  const double L = (xa - xb).norm();
  if (L == 0.0) {
    A = k * Mat3::Identity();
  } else {
    const Vec3 n = (xa - xb) / L;
    const Mat3 P = n * n.transpose();
    const Mat3 Q = Mat3::Identity() - P;
    A = k * P + k * (L - L0) * Q;
  }
  Mat6 K;
  K.block<3, 3>(0, 0) = A;
  K.block<3, 3>(0, 3) = -A;
  K.block<3, 3>(3, 0) = -A;
  K.block<3, 3>(3, 3) = A;
  return K;
}

static MatX denseHessian(const VecX& x, const std::vector<Spring>& springs) {
  MatX K = MatX::Zero(x.size(), x.size());
  for (auto it = springs.rbegin(); it != springs.rend(); ++it) {
    const int a = 3 * it->a, b = 3 * it->b;
    const Mat6 S = springHessian(x.segment(a, 3), x.segment(b, 3), it->k, it->L0);
    K.block(a, a, 3, 3) += S.topLeftCorner(3, 3);
    K.block(a, b, 3, 3) += S.topRightCorner(3, 3);
    K.block(b, a, 3, 3) += S.bottomLeftCorner(3, 3);
    K.block(b, b, 3, 3) += S.bottomRightCorner(3, 3);
  }
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  return denseHessian(x, springs).sparseView();
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX gradient = VecX::Zero(x.size());
  for (auto it = springs.rbegin(); it != springs.rend(); ++it) {
    const Vec3 r = x.segment(3 * it->a, 3) - x.segment(3 * it->b, 3);
    const double L = r.norm();
    if (L == 0.0) continue;
    const Vec3 n = r / L;
    gradient.segment(3 * it->a, 3) += it->k * (L - it->L0) * n;
    gradient.segment(3 * it->b, 3) -= it->k * (L - it->L0) * n;
  }
  return -gradient;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const MatX K = assembleHessian(now.x, springs);
  VecX masses(now.x.size());
  for (int i = 0; i < m.size(); ++i) masses.segment(3 * i, 3).setConstant(m[i]);
  MatX A = h * h * K;
  A.diagonal() += masses;
  const VecX b = h * (elasticForce(now.x, springs) + F) - h * h * (K * now.v);
  const VecX dv = A.partialPivLu().solve(b);
  State next = now;
  next.v += dv;
  next.x += h * next.v;
  return next;
}
