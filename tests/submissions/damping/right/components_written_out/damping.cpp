#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return Vec3(-d * va[0], -d * va[1], -d * va[2]); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  double fx = -d * (va[0] - vb[0]);
  double fy = -d * (va[1] - vb[1]);
  double fz = -d * (va[2] - vb[2]);
  return Vec3(fx, fy, fz);
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  double rx = xa[0] - xb[0], ry = xa[1] - xb[1], rz = xa[2] - xb[2];
  double L = std::sqrt(rx * rx + ry * ry + rz * rz);
  if (L == 0) return Vec3(0, 0, 0);
  double ux = rx / L, uy = ry / L, uz = rz / L;
  double rate = (va[0] - vb[0]) * ux + (va[1] - vb[1]) * uy + (va[2] - vb[2]) * uz;
  return Vec3(-d * rate * ux, -d * rate * uy, -d * rate * uz);
}
