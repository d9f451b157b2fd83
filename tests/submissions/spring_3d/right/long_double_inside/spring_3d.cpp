#include "spring_3d.h"

// long double keeps a few digits more where L and L0 cancel

static long double lengthOf(const Vec3& xa, const Vec3& xb) {
  const long double x = static_cast<long double>(xa[0]) - xb[0];
  const long double y = static_cast<long double>(xa[1]) - xb[1];
  const long double z = static_cast<long double>(xa[2]) - xb[2];
  return std::sqrt(x * x + y * y + z * z);
}

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return static_cast<double>(-k * (lengthOf(xa, xb) - L0));
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const long double L = lengthOf(xa, xb);
  Vec3 u = Vec3::Zero();
  if (L > 0)
    for (int i = 0; i < 3; ++i) u[i] = static_cast<double>((static_cast<long double>(xa[i]) - xb[i]) / L);
  return u;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springForceMagnitude(xa, xb, k, L0) * springDirection(xa, xb);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  long double sum[3] = {0, 0, -static_cast<long double>(m) * g};
  for (const Attachment& s : springs) {
    const Vec3 f = springForce(x, s.x, s.k, s.L0);
    for (int i = 0; i < 3; ++i) sum[i] += f[i];
  }
  return Vec3(double(sum[0] / m), double(sum[1] / m), double(sum[2] / m));
}
