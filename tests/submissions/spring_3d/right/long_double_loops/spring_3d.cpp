#include "spring_3d.h"

namespace {

struct Ray {
  long double d[3];
  long double length;
};

Ray between(const Vec3& xa, const Vec3& xb) {
  Ray r{{0, 0, 0}, 0};
  for (int i = 0; i < 3; ++i) {
    r.d[i] = static_cast<long double>(xa[i]) - xb[i];
    r.length += r.d[i] * r.d[i];
  }
  r.length = std::sqrt(r.length);
  return r;
}

void addForce(long double (&sum)[3], const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Ray r = between(xa, xb);
  if (r.length == 0) return;
  for (int i = 0; i < 3; ++i) sum[i] += k * (L0 - r.length) * (r.d[i] / r.length);
}

}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return static_cast<double>(k * (L0 - between(xa, xb).length));
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const Ray r = between(xa, xb);
  Vec3 u = Vec3::Zero();
  if (r.length > 0)
    for (int i = 0; i < 3; ++i) u[i] = static_cast<double>(r.d[i] / r.length);
  return u;
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  long double F[3] = {0, 0, 0};
  addForce(F, xa, xb, k, L0);
  return Vec3(static_cast<double>(F[0]), static_cast<double>(F[1]), static_cast<double>(F[2]));
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  long double F[3] = {0, 0, -static_cast<long double>(m) * g};
  for (const Attachment& s : springs) addForce(F, x, s.x, s.k, s.L0);
  return Vec3(static_cast<double>(F[0] / m), static_cast<double>(F[1] / m), static_cast<double>(F[2] / m));
}
