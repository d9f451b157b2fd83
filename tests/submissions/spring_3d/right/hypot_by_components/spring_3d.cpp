#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (std::hypot(xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]) - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  double dx = xa[0] - xb[0], dy = xa[1] - xb[1], dz = xa[2] - xb[2];
  double L = std::hypot(dx, dy, dz);
  if (L == 0) return Vec3(0, 0, 0);
  return Vec3(dx / L, dy / L, dz / L);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double size = springForceMagnitude(xa, xb, k, L0);
  Vec3 u = springDirection(xa, xb);
  return Vec3(size * u[0], size * u[1], size * u[2]);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  double fx = 0, fy = 0, fz = -m * g;
  for (const auto& s : springs) {
    Vec3 f = springForce(x, s.x, s.k, s.L0);
    fx += f[0];
    fy += f[1];
    fz += f[2];
  }
  return Vec3(fx / m, fy / m, fz / m);
}
