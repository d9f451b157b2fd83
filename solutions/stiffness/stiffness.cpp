#include "stiffness.h"

#include <Eigen/SparseLU>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  Mat3 A = k * Mat3::Identity();
  if (L > 0) {
    const Vec3 n = r / L;
    const Mat3 along = n * n.transpose();
    const double T = k * (L - L0);
    A = k * along + T / L * (Mat3::Identity() - along);
  }
  Mat6 K;
  K << A, -A, -A, A;
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const auto place = [&s](int i) { return i < 3 ? 3 * s.a + i : 3 * s.b + i - 3; };
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) entries.emplace_back(place(i), place(j), K(i, j));
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());  // adds up what comes twice
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 r = x.segment<3>(3 * s.a) - x.segment<3>(3 * s.b);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 Fa = -s.k * (L - s.L0) * (r / L);
    F.segment<3>(3 * s.a) += Fa;
    F.segment<3>(3 * s.b) -= Fa;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  SparseMatrix system = h * h * K;
  for (int i = 0; i < now.x.size(); ++i) system.coeffRef(i, i) += m[i / 3];
  system.makeCompressed();
  const VecX right = h * (elasticForce(now.x, springs) + F - h * (K * now.v));
  const Eigen::SparseLU<SparseMatrix> solver(system);
  const VecX v = now.v + solver.solve(right);
  return {now.x + h * v, v};
}
