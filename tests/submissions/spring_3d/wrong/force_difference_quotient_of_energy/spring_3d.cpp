// loses: HookeForce, ShortSpring; misconception: difference_quotient or edge or threshold or one_sided
// thought: F = -dE/dx
#include "spring_3d.h"

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 r = xa - xb;
  double L = r.norm();
  return -k * (L - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  Vec3 r = xa - xb;
  double L = r.norm();
  if (L == 0) {
    return Vec3::Zero();
  }
  return r / L;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double h = 1e-6;
  auto energy = [&](const Vec3& p) {
    double e = (p - xb).norm() - L0;
    return 0.5 * k * e * e;
  };
  Vec3 F;
  for (int i = 0; i < 3; i++) {
    Vec3 up = xa, down = xa;
    up[i] += h;
    down[i] -= h;
    F[i] = -(energy(up) - energy(down)) / (2 * h);
  }
  return F;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, -m * g);
  for (const Attachment& s : springs) {
    F += springForce(x, s.x, s.k, s.L0);
  }
  return F / m;
}
