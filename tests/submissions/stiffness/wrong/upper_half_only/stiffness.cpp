// loses: AssembleHessian; misconception: one_triangle
// Only the block (a, b) is entered, the block (b, a) is forgotten as if the matrix knew that it is symmetric.
#include "stiffness.h"

#include <Eigen/SparseLU>

typedef Eigen::Triplet<double> T;

Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Mat6 H;
  double d[3], n[3];
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    d[i] = xa(i) - xb(i);
    sum += d[i] * d[i];
  }
  double L = sqrt(sum);
  for (int i = 0; i < 3; i++) n[i] = L > 0 ? d[i] / L : 0.0;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      double delta = (i == j) ? 1.0 : 0.0;
      double value;
      if (L > 0)
        value = k * n[i] * n[j] + k * (L - L0) / L * (delta - n[i] * n[j]);
      else
        value = k * delta;
      H(i, j) = value;
      H(i, j + 3) = -value;
      H(i + 3, j) = -value;
      H(i + 3, j + 3) = value;
    }
  }
  return H;
}

SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs) {
  std::vector<T> list;
  list.reserve(36 * springs.size());
  for (size_t s = 0; s < springs.size(); s++) {
    int a = springs[s].a;
    int b = springs[s].b;
    Vec3 xa(x(3 * a), x(3 * a + 1), x(3 * a + 2));
    Vec3 xb(x(3 * b), x(3 * b + 1), x(3 * b + 2));
    Mat6 H = springHessian(xa, xb, springs[s].k, springs[s].L0);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        list.push_back(T(3 * a + i, 3 * a + j, H(i, j)));
        list.push_back(T(3 * a + i, 3 * b + j, H(i, j + 3)));
        list.push_back(T(3 * b + i, 3 * b + j, H(i + 3, j + 3)));
      }
    }
  }
  SparseMatrix K(x.size(), x.size());
  K.setFromTriplets(list.begin(), list.end());
  return K;
}

VecX elasticForce(const VecX& x, const std::vector<Spring>& springs) {
  VecX F = VecX::Zero(x.size());
  for (size_t s = 0; s < springs.size(); s++) {
    int a = springs[s].a;
    int b = springs[s].b;
    double dx = x(3 * b) - x(3 * a);
    double dy = x(3 * b + 1) - x(3 * a + 1);
    double dz = x(3 * b + 2) - x(3 * a + 2);
    double L = sqrt(dx * dx + dy * dy + dz * dz);
    if (L > 0) {
      double tension = springs[s].k * (L - springs[s].L0);
      F(3 * a) += tension * dx / L;
      F(3 * a + 1) += tension * dy / L;
      F(3 * a + 2) += tension * dz / L;
      F(3 * b) -= tension * dx / L;
      F(3 * b + 1) -= tension * dy / L;
      F(3 * b + 2) -= tension * dz / L;
    }
  }
  return F;
}

State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h) {
  SparseMatrix K = assembleHessian(now.x, springs);
  VecX total = elasticForce(now.x, springs) + F;
  std::vector<T> list;
  for (int col = 0; col < K.outerSize(); col++) {
    for (SparseMatrix::InnerIterator it(K, col); it; ++it) {
      list.push_back(T((int)it.row(), (int)it.col(), h * h * it.value()));
    }
  }
  for (int node = 0; node < m.size(); node++) {
    for (int c = 0; c < 3; c++) list.push_back(T(3 * node + c, 3 * node + c, m(node)));
  }
  SparseMatrix S(now.x.size(), now.x.size());
  S.setFromTriplets(list.begin(), list.end());
  VecX Kv = K * now.v;
  VecX rhs(now.x.size());
  for (int i = 0; i < rhs.size(); i++) rhs(i) = h * (total(i) - h * Kv(i));
  Eigen::SparseLU<SparseMatrix> lu;
  lu.compute(S);
  VecX dv = lu.solve(rhs);
  State next;
  next.v = now.v + dv;
  next.x = now.x + h * next.v;
  return next;
}
