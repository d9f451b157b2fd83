// plain loops over indices and components, springs from the last to the first
#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  int n = (int)m.size();
  SparseMatrix M(3 * n, 3 * n);
  M.reserve(Eigen::VectorXi::Constant(3 * n, 1));
  for (int i = 0; i < n; i++) {
    M.insert(3 * i, 3 * i) = m[i];
    M.insert(3 * i + 1, 3 * i + 1) = m[i];
    M.insert(3 * i + 2, 3 * i + 2) = m[i];
  }
  M.makeCompressed();
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double E = 0;
  for (int s = (int)springs.size() - 1; s >= 0; s--) {
    int a = springs[s].a;
    int b = springs[s].b;
    Vec3 xa(x[3 * a], x[3 * a + 1], x[3 * a + 2]);
    Vec3 xb(x[3 * b], x[3 * b + 1], x[3 * b + 2]);
    E = E + energy(xa, xb, springs[s].k, springs[s].L0);
  }
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  VecX G(x.size());
  for (int i = 0; i < x.size(); i++) G[i] = 0;
  for (int s = (int)springs.size() - 1; s >= 0; s--) {
    int a = springs[s].a;
    int b = springs[s].b;
    Vec3 xa(x[3 * a], x[3 * a + 1], x[3 * a + 2]);
    Vec3 xb(x[3 * b], x[3 * b + 1], x[3 * b + 2]);
    Vec6 g = gradient(xa, xb, springs[s].k, springs[s].L0);
    for (int j = 0; j < 3; j++) {
      G[3 * a + j] += g[j];
      G[3 * b + j] += g[j + 3];
    }
  }
  return G;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  VecX G = systemGradient(x, springs, gradient);
  VecX acc(x.size());
  for (int i = 0; i < x.size(); i++) {
    acc[i] = (F[i] - G[i]) / m[i / 3];
  }
  return acc;
}
