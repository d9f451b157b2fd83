// loses: all; misconception: zero
#include "stiffness.h"

Mat6 springHessian(const Vec3&, const Vec3&, double, double) { return Mat6::Zero(); }

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>&) { return SparseMatrix(x.size(), x.size()); }

VecX elasticForce(const VecX& x, const std::vector<Spring>&) { return VecX::Zero(x.size()); }

State backwardEulerStep(const State& now, const VecX&, const std::vector<Spring>&, const VecX&, double) {
  return {VecX::Zero(now.x.size()), VecX::Zero(now.x.size())};
}
