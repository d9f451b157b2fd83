#include "stiffness.h"

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  (void)xa, (void)xb, (void)k, (void)L0;  // delete this line once you use them
  return Mat6::Zero();
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  (void)springs;
  return SparseMatrix(x.size(), x.size());
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  (void)springs;
  return VecX::Zero(x.size());
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  (void)m, (void)springs, (void)F, (void)h;
  return {VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}
