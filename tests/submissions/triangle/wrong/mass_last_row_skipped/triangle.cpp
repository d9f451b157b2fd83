// loses: MassMatrix; misconception: last_skipped
// row < 8
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M;
  for (int i = 0; i < 9; i++) {
    for (int j = 0; j < 9; j++) {
      M(i, j) = 0.0;
    }
  }
  for (int node = 0; node < 3; node++) {
    for (int c = 0; c < 3; c++) {
      int row = 3 * node + c;
      if (row < 8) M(row, row) = m(node);
    }
  }
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 0; s < 3; s++) {
    int a = 3 * s;
    int b = 3 * (s + 1);
    if (b == 9) b = 0;
    double L = std::hypot(x(a) - x(b), x(a + 1) - x(b + 1), x(a + 2) - x(b + 2));
    E = E + 0.5 * k(s) * (L - L0(s)) * (L - L0(s));
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double f[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  for (int s = 0; s < 3; s++) {
    int a = 3 * s;
    int b = 3 * (s + 1);
    if (b == 9) b = 0;
    double dx = x(a) - x(b);
    double dy = x(a + 1) - x(b + 1);
    double dz = x(a + 2) - x(b + 2);
    double L = std::hypot(dx, dy, dz);
    if (L > 0.0) {
      double t = k(s) * (L - L0(s));
      f[a] -= t * (dx / L);
      f[a + 1] -= t * (dy / L);
      f[a + 2] -= t * (dz / L);
      f[b] += t * (dx / L);
      f[b + 1] += t * (dy / L);
      f[b + 2] += t * (dz / L);
    }
  }
  Vec9 F;
  for (int i = 0; i < 9; i++) F(i) = f[i];
  return F;
}
