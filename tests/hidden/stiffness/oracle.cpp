/// \file
/// The expected values with dense matrices, and the Hessian by components: k ((1 - L0/L) delta_ij + L0 r_i r_j / L^3).

#include "stiffness.h"

#include "engine/solve/dense.h"

#include <stdexcept>

namespace {

using muelle::MatX;

/// The node in x; throws std::logic_error for a spring that is none.
Vec3 nodeOf(const VecX& x, int i) {
  if (i < 0 || 3 * i + 3 > x.size()) throw std::logic_error("a spring ends at a node that is not there");
  return x.segment<3>(3 * i);
}

void expectSpring(const Spring& s) {
  if (s.a == s.b) throw std::logic_error("a spring joins a node to itself");
}

double lengthOf(const Vec3& r) { return std::hypot(r[0], r[1], r[2]); }

}  // namespace

namespace oracle {

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = lengthOf(r);
  Mat6 K;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double same = i == j ? 1 : 0;
      const double a = L > 0 ? k * ((1 - L0 / L) * same + L0 / L * (r[i] / L) * (r[j] / L)) : k * same;
      K(i, j) = K(i + 3, j + 3) = a;
      K(i + 3, j) = K(i, j + 3) = -a;
    }
  }
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  MatX K = MatX::Zero(x.size(), x.size());
  for (const Spring& s : springs) {
    expectSpring(s);
    const Mat6 one = given::springHessian(nodeOf(x, s.a), nodeOf(x, s.b), s.k, s.L0);
    const std::array<int, 2> ends = {3 * s.a, 3 * s.b};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        K(ends[static_cast<std::size_t>(i / 3)] + i % 3, ends[static_cast<std::size_t>(j / 3)] + j % 3) += one(i, j);
      }
    }
  }
  return K.sparseView(0, 0);
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    expectSpring(s);
    const Vec3 r = nodeOf(x, s.b) - nodeOf(x, s.a);
    const double L = lengthOf(r);
    for (int i = 0; i < 3 && L > 0; ++i) {
      const double pull = s.k * (L - s.L0) * (r[i] / L);
      F[3 * s.a + i] += pull;
      F[3 * s.b + i] -= pull;
    }
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  if (now.v.size() != now.x.size() || F.size() != now.x.size() || 3 * m.size() != now.x.size()) {
    throw std::logic_error("vectors of other lengths than the net has");
  }
  const MatX K = given::assembleHessian(now.x, springs);
  VecX M(now.x.size());
  for (Eigen::Index i = 0; i < M.size(); ++i) M[i] = m[i / 3];
  const MatX system = MatX(M.asDiagonal()) + h * h * K;
  const VecX force = given::elasticForce(now.x, springs) + F;
  // The same equation for v1: (M + h^2 K) v1 = M v + h F.
  const VecX v = muelle::engine::solvePartialPivoting(system, M.cwiseProduct(now.v) + h * force);
  return {now.x + h * v, v};
}

}  // namespace oracle
