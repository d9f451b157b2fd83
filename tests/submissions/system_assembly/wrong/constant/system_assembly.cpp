// loses: all; misconception: constant
// numbers to look at
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setIdentity();
  return 2.5 * M;
}

double systemEnergy(const VecX&, const std::vector<Spring>&, const SpringEnergy&) { return 42.0; }

VecX systemGradient(const VecX& x, const std::vector<Spring>&, const SpringGradient&) {
  return VecX::Constant(x.size(), 1.5);
}

VecX systemAccelerations(const VecX& x, const VecX&, const std::vector<Spring>&, const SpringGradient&, const VecX&) {
  return VecX::Constant(x.size(), -9.81);
}
