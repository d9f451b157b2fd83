#include "triangle.h"

static Vec3 pullTowards(const Vec3& from, const Vec3& to, double k, double L0) {
  const Vec3 r = to - from;
  const double L = std::hypot(r.x(), r.y(), r.z());
  if (L > 0) return k * (L - L0) * Vec3(r.x() / L, r.y() / L, r.z() / L);
  return Vec3(0, 0, 0);
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M;
  for (int row = 0; row < 9; ++row)
    for (int col = 0; col < 9; ++col) M(row, col) = row == col ? m(row / 3) : 0.0;
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  auto energy = [&](int s, int i, int j) {
    const double L = std::hypot(x[3 * i] - x[3 * j], x[3 * i + 1] - x[3 * j + 1], x[3 * i + 2] - x[3 * j + 2]);
    return k[s] * std::pow(L - L0[s], 2) / 2;
  };
  return energy(2, 2, 0) + energy(1, 1, 2) + energy(0, 0, 1);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec3 x0 = x.head<3>(), x1 = x.segment<3>(3), x2 = x.tail<3>();
  Vec9 F;
  F << pullTowards(x0, x1, k[0], L0[0]) + pullTowards(x0, x2, k[2], L0[2]),
      pullTowards(x1, x0, k[0], L0[0]) + pullTowards(x1, x2, k[1], L0[1]),
      pullTowards(x2, x1, k[1], L0[1]) + pullTowards(x2, x0, k[2], L0[2]);
  return F;
}
