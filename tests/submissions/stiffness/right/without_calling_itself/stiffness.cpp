#include "stiffness.h"

#include <Eigen/LU>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  Mat3 A = k * Mat3::Identity();
  if (L > 0) {
    const Vec3 n = r / L;
    const Mat3 along = n * n.transpose();
    const Mat3 across = Mat3::Identity() - along;
    A = k * along + k * (L - L0) / L * across;
  }
  Mat6 K;
  K << A, -A, -A, A;
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<Eigen::Triplet<double>> list;
  for (const Spring& s : springs) {
    const Mat6 K = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const int start[2] = {3 * s.a, 3 * s.b};
    for (int p = 0; p < 2; ++p) {
      for (int q = 0; q < 2; ++q) {
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) list.emplace_back(start[p] + i, start[q] + j, K(3 * p + i, 3 * q + j));
        }
      }
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(list.begin(), list.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Vec3 r = x.segment<3>(3 * s.a) - x.segment<3>(3 * s.b);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 onA = -s.k * (L - s.L0) / L * r;
    F.segment<3>(3 * s.a) += onA;
    F.segment<3>(3 * s.b) -= onA;
  }
  return F;
}

// Everything in one loop over the springs.
State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const Eigen::Index n = now.x.size();
  muelle::MatX S = muelle::MatX::Zero(n, n);
  VecX rhs = h * F;
  for (Eigen::Index i = 0; i < n; ++i) S(i, i) = m[i / 3];
  for (const Spring& s : springs) {
    const Eigen::Index a = 3 * s.a, b = 3 * s.b;
    const Vec3 r = now.x.segment<3>(a) - now.x.segment<3>(b);
    const Vec3 speed = now.v.segment<3>(a) - now.v.segment<3>(b);
    const double L = r.norm();
    Mat3 A = s.k * Mat3::Identity();
    Vec3 push = Vec3::Zero();
    if (L > 0) {
      const Vec3 e = r / L;
      const double tension = s.k * (L - s.L0);
      A = (s.k - tension / L) * e * e.transpose();
      A.diagonal().array() += tension / L;
      push = -tension * e;
    }
    S.block<3, 3>(a, a) += h * h * A;
    S.block<3, 3>(b, b) += h * h * A;
    S.block<3, 3>(a, b) -= h * h * A;
    S.block<3, 3>(b, a) -= h * h * A;
    const Vec3 all = h * push - h * h * (A * speed);
    rhs.segment<3>(a) += all;
    rhs.segment<3>(b) -= all;
  }
  const VecX v1 = now.v + S.fullPivLu().solve(rhs);
  return {now.x + h * v1, v1};
}
