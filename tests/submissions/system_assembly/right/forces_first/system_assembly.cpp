#include "system_assembly.h"

static Vec3 at(const VecX& x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); }

/// What the springs do to all nodes.
static VecX springForces(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX forces = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec6 g = gradient(at(x, s.a), at(x, s.b), s.k, s.L0);
    forces.segment<3>(3 * s.a) -= g.head<3>();
    forces.segment<3>(3 * s.b) -= g.tail<3>();
  }
  return forces;
}

SparseMatrix systemMassMatrix(const VecX& m) {
  const Eigen::Index size = 3 * m.size();
  SparseMatrix mass(size, size);
  mass.reserve(Eigen::VectorXi::Constant(size, 1));
  for (Eigen::Index i = 0; i < m.size(); i++) {
    mass.insert(3 * i, 3 * i) = m(i);
    mass.insert(3 * i + 1, 3 * i + 1) = m(i);
    mass.insert(3 * i + 2, 3 * i + 2) = m(i);
  }
  mass.makeCompressed();
  return mass;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double total = 0.0;
  for (std::size_t i = 0; i < springs.size(); i++) {
    const Spring& spring = springs[i];
    total = total + energy(at(x, spring.a), at(x, spring.b), spring.k, spring.L0);
  }
  return total;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  return -springForces(x, springs, gradient);
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  VecX a = springForces(x, springs, gradient) + F;
  for (int i = 0; i < m.size(); i++) a.segment<3>(3 * i) /= m[i];
  return a;
}
