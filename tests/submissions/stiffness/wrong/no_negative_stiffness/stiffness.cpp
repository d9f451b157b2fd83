// loses: SpringHessian, GeometricPart, DerivativeOfForce; misconception: compression_left_out
// The geometric part of a compressed spring is cut to zero, to have a matrix that is never indefinite.
#include "stiffness.h"

namespace {

std::vector<double> gauss(std::vector<std::vector<double>> A, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r) {
      if (std::abs(A[r][c]) > std::abs(A[pivot][c])) pivot = r;
    }
    std::swap(A[c], A[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double factor = A[r][c] / A[c][c];
      if (factor == 0) continue;
      for (std::size_t j = c; j < n; ++j) A[r][j] -= factor * A[c][j];
      b[r] -= factor * b[c];
    }
  }
  std::vector<double> x(n);
  for (std::size_t i = n; i-- > 0;) {
    double sum = b[i];
    for (std::size_t j = i + 1; j < n; ++j) sum -= A[i][j] * x[j];
    x[i] = sum / A[i][i];
  }
  return x;
}

}  // namespace

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Mat6 D = Mat6::Identity();
  D.topRightCorner<3, 3>().diagonal().setConstant(-1);
  D.bottomLeftCorner<3, 3>().diagonal().setConstant(-1);
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (!(L > 0)) return k * D;
  Eigen::Matrix<double, 6, 1> g;
  g << r / L, -r / L;
  const Mat6 along = g * g.transpose();
  const double tension = std::max(0.0, k * (L - L0));  // keep it positive definite
  return k * along + tension / L * (D - along);
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  SparseMatrix K(x.size(), x.size());
  for (const Spring& s : springs) {
    const Mat6 H = springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const int node[2] = {s.a, s.b};
    for (int p = 0; p < 2; ++p) {
      for (int q = 0; q < 2; ++q) {
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) K.coeffRef(3 * node[p] + i, 3 * node[q] + j) += H(3 * p + i, 3 * q + j);
        }
      }
    }
  }
  K.makeCompressed();
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F(x.size());
  for (int i = 0; i < x.size() / 3; ++i) {
    const Vec3 xi = x.segment<3>(3 * i);
    Vec3 sum = Vec3::Zero();
    for (const Spring& s : springs) {
      if (s.a != i && s.b != i) continue;
      const int other = s.a == i ? s.b : s.a;
      const Vec3 towards = x.segment<3>(3 * other) - xi;
      const double L = towards.norm();
      if (L > 0) sum += s.k * (L - s.L0) * (towards / L);
    }
    F.segment<3>(3 * i) = sum;
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  const SparseMatrix K = assembleHessian(now.x, springs);
  const VecX total = elasticForce(now.x, springs) + F;
  const VecX Kv = K * now.v;
  const std::size_t n = static_cast<std::size_t>(now.x.size());
  std::vector<std::vector<double>> A(n, std::vector<double>(n, 0.0));
  std::vector<double> b(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int row = static_cast<int>(i);
    for (std::size_t j = 0; j < n; ++j) A[i][j] = h * h * K.coeff(row, static_cast<int>(j));
    A[i][i] += m[row / 3];
    b[i] = h * (total[row] - h * Kv[row]);
  }
  const std::vector<double> dv = gauss(A, b);
  State next{VecX(now.x.size()), VecX(now.x.size())};
  for (int i = 0; i < now.x.size(); ++i) {
    next.v[i] = now.v[i] + dv[static_cast<std::size_t>(i)];
    next.x[i] = now.x[i] + h * next.v[i];
  }
  return next;
}
