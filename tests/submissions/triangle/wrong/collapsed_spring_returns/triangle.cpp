// loses: CoincidentNodes; misconception: coincident_stops_all
// return where continue was meant: what was added before is kept, the springs after it are lost
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block<3, 3>(3 * i, 3 * i) = m[i] * Mat3::Identity();
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0.0;
  for (int s = 0, t = 1; s < 3; ++s, t = (t + 1) % 3) {
    const double stretch = (x.segment<3>(3 * s) - x.segment<3>(3 * t)).norm() - L0[s];
    E += k[s] * stretch * stretch * 0.5;
  }
  return E;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0, t = 1; s < 3; ++s, t = (t + 1) % 3) {
    const Vec3 r = x.segment<3>(3 * s) - x.segment<3>(3 * t);
    const double L = r.norm();
    if (L == 0) return F;
    const Vec3 f = -k[s] * (L - L0[s]) * r / L;
    F.segment<3>(3 * s) += f;
    F.segment<3>(3 * t) -= f;
  }
  return F;
}
