// loses: all; misconception: zero
// as it was handed out
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) { return SparseMatrix(3 * m.size(), 3 * m.size()); }

double systemEnergy(const VecX&, const std::vector<Spring>&, const SpringEnergy&) { return 0.0; }

VecX systemGradient(const VecX& x, const std::vector<Spring>&, const SpringGradient&) { return VecX::Zero(x.size()); }

VecX systemAccelerations(const VecX& x, const VecX&, const std::vector<Spring>&,
                         const SpringGradient&, const VecX&) {
  return VecX::Zero(x.size());
}
