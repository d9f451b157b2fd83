#include "stiffness.h"

#include <Eigen/LU>

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  using Number = long double;
  Number d[3], sum = 0;
  for (int i = 0; i < 3; ++i) {
    d[i] = Number(xa[i]) - Number(xb[i]);
    sum += d[i] * d[i];
  }
  const Number L = std::sqrt(sum);
  Mat3 A;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Number delta = i == j ? 1 : 0;
      const Number nn = L > 0 ? d[i] / L * (d[j] / L) : delta;
      const Number across = L > 0 ? (L - Number(L0)) / L : 1;
      A(i, j) = static_cast<double>(Number(k) * (nn + across * (delta - nn)));
    }
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

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const muelle::MatX K = assembleHessian(now.x, springs);
  muelle::MatX A = h * h * K;
  for (int i = 0; i < now.x.size(); ++i) A(i, i) += m[i / 3];
  const VecX b = h * (elasticForce(now.x, springs) + F - h * (K * now.v));
  const VecX dv = A.partialPivLu().solve(b);
  State next;
  next.v = now.v + dv;
  next.x = now.x + h * next.v;
  return next;
}
