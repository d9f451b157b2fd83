#include "stiffness.h"

#include <Eigen/LU>

namespace {

struct Stick {
  Vec3 n;
  double L;
};

Stick stick(const Vec3& xa, const Vec3& xb) {
  const Vec3 r = xa - xb;
  const double L = r.stableNorm();
  return {L > 0 ? Vec3(r / L) : Vec3(0, 0, 0), L};
}

Mat3 block(const Stick& s, double k, double L0) {
  if (s.L == 0) return k * Mat3::Identity();
  const double c = 1 - L0 / s.L;
  return k * (c * Mat3::Identity() + (1 - c) * s.n * s.n.transpose());
}

}  // namespace

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Mat3 A = block(stick(xa, xb), k, L0);
  Mat6 K;
  K.topLeftCorner<3, 3>() = A;
  K.topRightCorner<3, 3>() = -A;
  K.bottomLeftCorner<3, 3>() = -A;
  K.bottomRightCorner<3, 3>() = A;
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
    const Stick at = stick(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b));
    const double T = s.k * (at.L - s.L0);
    F.segment<3>(3 * s.b) += T * at.n;
    F.segment<3>(3 * s.a) -= T * at.n;
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
