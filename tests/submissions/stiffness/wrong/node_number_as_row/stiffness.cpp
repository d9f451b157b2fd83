// loses: AssembleHessian; misconception: none
// The column of an entry is the number of the node plus the component, the factor 3 is forgotten there.
#include "stiffness.h"

#include <Eigen/SparseLU>

#include <map>
#include <utility>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Mat3 A = Mat3::Identity() * k;
  const Vec3 d = xb - xa;
  if (d != Vec3::Zero()) {
    const double L = d.norm();
    const Vec3 n = d / L;
    const double across = k * (L - L0) / L;
    for (int i = 0; i < 3; ++i) {
      const Vec3 e = Vec3::Unit(i);
      const Vec3 parallel = n.dot(e) * n;
      A.col(i) = k * parallel + across * (e - parallel);
    }
  }
  Mat6 K;
  K << A, -A, -A, A;
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::map<std::pair<int, int>, Mat3> blocks;
  const auto add = [&blocks](int row, int column, const Mat3& A) {
    const auto [place, isNew] = blocks.try_emplace({row, column}, A);
    if (!isNew) place->second += A;
  };
  for (const auto& [a, b, k, L0] : springs) {
    const Mat6 K = springHessian(x.segment<3>(3 * a), x.segment<3>(3 * b), k, L0);
    add(a, a, K.topLeftCorner<3, 3>());
    add(a, b, K.topRightCorner<3, 3>());
    add(b, a, K.bottomLeftCorner<3, 3>());
    add(b, b, K.bottomRightCorner<3, 3>());
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [place, A] : blocks) {
    for (int e = 0; e < 9; ++e) {
      entries.emplace_back(3 * place.first + e / 3, place.second + e % 3, A(e / 3, e % 3));
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const auto& [a, b, k, L0] : springs) {
    const Vec3 d = x.segment<3>(3 * b) - x.segment<3>(3 * a);
    if (d == Vec3::Zero()) continue;
    const double L = d.norm();
    const Vec3 pull = k * (L - L0) * (d / L);
    F.segment<3>(3 * a) += pull;
    F.segment<3>(3 * b) -= pull;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const auto size = now.x.size();
  VecX mass(size);
  for (int i = 0; i < size; ++i) mass[i] = m[i / 3];
  SparseMatrix M(size, size);
  M.setIdentity();
  M = SparseMatrix(mass.asDiagonal() * M);
  const SparseMatrix K = assembleHessian(now.x, springs);
  SparseMatrix A = M + h * h * K;
  A.makeCompressed();
  Eigen::SparseLU<SparseMatrix> solver;
  solver.analyzePattern(A);
  solver.factorize(A);
  const VecX b = mass.cwiseProduct(now.v) + h * (elasticForce(now.x, springs) + F);
  const VecX v1 = solver.solve(b);
  return {now.x + h * v1, v1};
}
