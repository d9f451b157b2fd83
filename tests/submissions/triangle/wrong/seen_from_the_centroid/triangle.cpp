// loses: TinyLengths; misconception: none
// positions are first taken relative to the centroid: equal in algebra, but a very short side is rounded away
#include "triangle.h"

static Vec9 centred(const Vec9& x) {
  const Vec3 centroid = (x.segment<3>(0) + x.segment<3>(3) + x.segment<3>(6)) / 3.0;
  Vec9 y;
  for (int i = 0; i < 3; ++i) y.segment<3>(3 * i) = x.segment<3>(3 * i) - centroid;
  return y;
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec9 y = centred(x);
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    const double L = (y.segment<3>(3 * s) - y.segment<3>(3 * ((s + 1) % 3))).norm();
    E += 0.5 * k[s] * (L - L0[s]) * (L - L0[s]);
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec9 y = centred(x);
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const int i = 3 * s, j = 3 * ((s + 1) % 3);
    const Vec3 r = y.segment<3>(i) - y.segment<3>(j);
    const double L = r.norm();
    if (L == 0) continue;
    const Vec3 f = -k[s] * (L - L0[s]) * r / L;
    F.segment<3>(i) += f;
    F.segment<3>(j) -= f;
  }
  return F;
}
