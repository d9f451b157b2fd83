// loses: AssembleHessian; misconception: last_skipped
#include "stiffness.h"

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double r[3] = {xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]};
  const double L = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double same = i == j ? 1.0 : 0.0;
      double A = k * same;
      if (L > 0) {
        const double nn = r[i] / L * (r[j] / L);
        A = k * nn + k * (L - L0) / L * (same - nn);
      }
      K(i, j) = A;
      K(i, j + 3) = -A;
      K(i + 3, j) = -A;
      K(i + 3, j + 3) = A;
    }
  }
  return K;
}

namespace {

Vec3 node(const VecX& x, int i) { return Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]); }

}  // namespace

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  SparseMatrix result(x.size(), x.size());
  for (std::size_t q = 0; q + 1 < springs.size(); ++q) {
    const Spring& s = springs[q];
    const Mat6 K = springHessian(node(x, s.a), node(x, s.b), s.k, s.L0);
    const int start[2] = {3 * s.a, 3 * s.b};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) result.coeffRef(start[i / 3] + i % 3, start[j / 3] + j % 3) += K(i, j);
    }
  }
  return result;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const int a = 3 * s.a, b = 3 * s.b;
    const double r[3] = {x[a] - x[b], x[a + 1] - x[b + 1], x[a + 2] - x[b + 2]};
    const double L = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    if (L == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const double onA = -s.k * (L - s.L0) / L * r[c];
      F[a + c] += onA;
      F[b + c] -= onA;
    }
  }
  return F;
}

namespace {

using Rows = std::vector<std::vector<double>>;

/// Gauss, with the largest number of the column as pivot.
std::vector<double> solve(Rows A, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t best = p;
    for (std::size_t r = p + 1; r < n; ++r) {
      if (std::abs(A[r][p]) > std::abs(A[best][p])) best = r;
    }
    std::swap(A[p], A[best]);
    std::swap(b[p], b[best]);
    for (std::size_t r = p + 1; r < n; ++r) {
      const double factor = A[r][p] / A[p][p];
      for (std::size_t c = p; c < n; ++c) A[r][c] -= factor * A[p][c];
      b[r] -= factor * b[p];
    }
  }
  for (std::size_t p = n; p-- > 0;) {
    for (std::size_t c = p + 1; c < n; ++c) b[p] -= A[p][c] * b[c];
    b[p] /= A[p][p];
  }
  return b;
}

}  // namespace

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  const VecX elastic = elasticForce(now.x, springs);
  const auto n = static_cast<std::size_t>(now.x.size());
  Rows A(n, std::vector<double>(n, 0.0));
  std::vector<double> b(n, 0.0), Kv(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const int row = static_cast<int>(i);
    for (std::size_t j = 0; j < n; ++j) {
      const double Kij = K.coeff(row, static_cast<int>(j));
      A[i][j] = h * h * Kij;
      Kv[i] += Kij * now.v[static_cast<int>(j)];
    }
    A[i][i] += m[row / 3];
    b[i] = h * (elastic[row] + F[row] - h * Kv[i]);
  }
  const std::vector<double> dv = solve(A, b);
  State next = now;
  for (int i = 0; i < now.x.size(); ++i) {
    next.v[i] = now.v[i] + dv[static_cast<std::size_t>(i)];
    next.x[i] = now.x[i] + h * next.v[i];
  }
  return next;
}
