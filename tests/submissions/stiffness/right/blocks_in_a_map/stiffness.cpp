#include "stiffness.h"

#include <Eigen/SparseLU>
#include <map>
#include <utility>

namespace {

/// A spring as it is now.
class Stretched {
 public:
  Stretched(const Vec3& xa, const Vec3& xb, double k, double L0) : k_(k), length_((xa - xb).norm()) {
    if (hasDirection()) {
      direction_ = (xa - xb) / length_;
      tension_ = k * (length_ - L0);
    }
  }

  bool hasDirection() const { return length_ > 0; }

  /// The force on its node a.
  Vec3 force() const { return -tension_ * direction_; }

  /// The second derivatives of its energy with respect to its node a, number by number.
  Mat3 block() const {
    Mat3 A;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const double same = i == j ? 1.0 : 0.0;
        if (!hasDirection()) {
          A(i, j) = k_ * same;
        } else {
          const double along = direction_[i] * direction_[j];
          A(i, j) = k_ * along + tension_ / length_ * (same - along);
        }
      }
    }
    return A;
  }

 private:
  double k_;
  double length_;
  double tension_ = 0.0;
  Vec3 direction_ = Vec3::Zero();
};

Stretched at(const VecX& x, const Spring& s) {
  return Stretched(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
}

}  // namespace

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Mat3 A = Stretched(xa, xb, k, L0).block();
  Mat6 K;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double sign = (row < 3) == (column < 3) ? 1.0 : -1.0;
      K(row, column) = sign * A(row % 3, column % 3);
    }
  }
  return K;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::map<std::pair<int, int>, Mat3> blocks;  // (row, column) of nodes
  const auto add = [&blocks](int row, int column, const Mat3& block) {
    const auto [place, isNew] = blocks.try_emplace({row, column}, block);
    if (!isNew) place->second += block;
  };
  for (auto s = springs.rbegin(); s != springs.rend(); ++s) {
    const Mat3 A = at(x, *s).block();
    add(s->b, s->b, A);
    add(s->b, s->a, -A);
    add(s->a, s->b, -A);
    add(s->a, s->a, A);
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * blocks.size());
  for (const auto& [place, block] : blocks) {
    for (int i = 0; i < 9; ++i) entries.emplace_back(3 * place.first + i / 3, 3 * place.second + i % 3, block(i / 3, i % 3));
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (auto s = springs.rbegin(); s != springs.rend(); ++s) {
    const Vec3 onA = at(x, *s).force();
    for (int c = 0; c < 3; ++c) {
      F[3 * s->a + c] += onA[c];
      F[3 * s->b + c] -= onA[c];
    }
  }
  return F;
}

// With v1 = v + dv the equation reads (M + h^2 K) v1 = M v + h F_total: solved for the new velocity itself.
State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const Eigen::Index size = now.x.size();
  VecX masses(size);
  for (Eigen::Index r = 0; r < size; ++r) masses[r] = m[r / 3];
  SparseMatrix M(size, size);
  M.setIdentity();
  M.diagonal() = masses;
  SparseMatrix system = assembleHessian(now.x, springs);
  system *= h * h;
  system += M;
  const VecX right = masses.cwiseProduct(now.v) + h * (elasticForce(now.x, springs) + F);
  Eigen::SparseLU<SparseMatrix> solver(system);
  State next{now.x, solver.solve(right)};
  next.x += h * next.v;
  return next;
}
