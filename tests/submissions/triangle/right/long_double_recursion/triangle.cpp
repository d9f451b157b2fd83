#include "triangle.h"

namespace {

using Long = long double;
using Nine = std::array<Long, 9>;

Long lengthOfSpring(const Vec9& x, int s) {
  Long sum = 0;
  for (int c = 2; c >= 0; --c) {
    const Long d = static_cast<Long>(x[3 * s + c]) - x[(3 * s + 3 + c) % 9];
    sum += d * d;
  }
  return std::sqrt(sum);
}

Long energyFrom(int s, const Vec9& x, const Vec3& k, const Vec3& L0) {
  if (s == 3) return 0;
  const Long stretch = lengthOfSpring(x, s) - L0[s];
  return energyFrom(s + 1, x, k, L0) + stretch * stretch * k[s] / 2;
}

void addForcesFrom(int s, Nine& F, const Vec9& x, const Vec3& k, const Vec3& L0) {
  if (s == 3) return;
  const Long L = lengthOfSpring(x, s);
  for (int c = 0; c < 3 && L > 0; ++c) {
    const int i = 3 * s + c, j = (i + 3) % 9;
    const Long f = k[s] * (L0[s] - L) * (static_cast<Long>(x[i]) - x[j]) / L;
    F[i] += f;
    F[j] -= f;
  }
  addForcesFrom(s + 1, F, x, k, L0);
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  return static_cast<double>(energyFrom(0, x, k, L0));
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Nine sum{};
  addForcesFrom(0, sum, x, k, L0);
  Vec9 F;
  for (int i = 0; i < 9; ++i) F[i] = static_cast<double>(sum[i]);
  return F;
}
