#include "engine/analysis/test_oscillator.h"

#include <cmath>

namespace muelle::engine {

void TestOscillator::force(double, In x, In v, In, Out f) const { f[0] = -stiffness * x[0] - (damping + drag1) * v[0]; }

double TestOscillator::energy(double, In x, In) const { return 0.5 * stiffness * x[0] * x[0]; }

void TestOscillator::conservativeForce(double, In x, In, Out f) const { f[0] = -stiffness * x[0]; }

void TestOscillator::discreteGradientForce(double, In xa, In xb, In, Out f) const {
  f[0] = -stiffness * 0.5 * (xa[0] + xb[0]);
}

void TestOscillator::accelerationWithoutDrag(double, In x, In v, In, Out a) const {
  a[0] = -stiffness * x[0] - damping * v[0];
}

void TestOscillator::assemble(double cM, double cD, double cK, double, In, In, In, Form, SystemMatrix& J) const {
  if (J.sparse.rows() != 1 || J.sparse.nonZeros() != 1) {
    J.sparse.resize(1, 1);
    J.sparse.insert(0, 0) = 0.0;
    J.sparse.makeCompressed();
  }
  J.sparse.valuePtr()[0] = cM + cD * (damping + drag1) + cK * stiffness;
  J.lowRank = {};
  J.symmetric = true;
}

Constraint TestOscillator::constraintAt(double x) const {
  Constraint out;
  out.kind = Constraint::Kind::Distance;
  out.count = 1;
  out.lane[0] = 0;
  out.gradient[0] = 1.0;
  out.value = x;
  out.stiffness = stiffness;
  out.damping = damping;
  return out;
}

void TestOscillator::evaluate(double, In x, In, const ConstraintBlocks::Take& take) const {
  const Constraint constraint = constraintAt(x[0]);
  if (stiffness > 0.0) take({&constraint, 1});
}

void TestOscillator::project(double, In, const ConstraintProjection& projection) const {
  if (stiffness > 0.0) projection(constraintAt(projection.x[0]));
}

void TestOscillator::externalForce(double, In, In v, In, Out f) const {
  f[0] = -drag1 * v[0] - (stiffness > 0.0 ? 0.0 : stiffness + damping * v[0]);
}

}  // namespace muelle::engine
