#include "spring_3d.h"

// everything written out, component by component

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double dx = xa[0] - xb[0];
  double dy = xa[1] - xb[1];
  double dz = xa[2] - xb[2];
  double L = std::sqrt(dx * dx + dy * dy + dz * dz);
  double deformation = L - L0;
  return -k * deformation;
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  double dx = xa[0] - xb[0];
  double dy = xa[1] - xb[1];
  double dz = xa[2] - xb[2];
  double L = std::sqrt(dx * dx + dy * dy + dz * dz);
  if (L > 0) {
    return Vec3(dx / L, dy / L, dz / L);
  } else {
    return Vec3(0, 0, 0);
  }
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  double F = springForceMagnitude(xa, xb, k, L0);
  Vec3 u = springDirection(xa, xb);
  return Vec3(F * u[0], F * u[1], F * u[2]);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  double Fx = 0, Fy = 0, Fz = -m * g;
  for (const Attachment& s : springs) {
    Vec3 F = springForce(x, s.x, s.k, s.L0);
    Fx += F[0];
    Fy += F[1];
    Fz += F[2];
  }
  return Vec3(Fx / m, Fy / m, Fz / m);
}
