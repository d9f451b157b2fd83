// loses: all; misconception: constant
#include "stiffness.h"

Mat6 springHessian(const Vec3&, const Vec3&, double, double) { return Mat6::Constant(1); }

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>&) {
  return muelle::MatX(muelle::MatX::Constant(x.size(), x.size(), 1)).sparseView();
}

VecX elasticForce(const VecX& x, const std::vector<Spring>&) { return VecX::Constant(x.size(), 1); }

State backwardEulerStep(const State& now, const VecX&, const std::vector<Spring>&, const VecX&, double) {
  return {VecX::Constant(now.x.size(), 1), VecX::Constant(now.x.size(), 1)};
}
