#include "contact.h"

#include <numeric>

namespace {

long double dot(const Vec3& a, const Vec3& b) {
  long double sum = 0.0L;
  for (int i = 0; i < 3; ++i) sum += static_cast<long double>(a[i]) * b[i];
  return sum;
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const Vec3 offset = p - x;
  const long double depth = dot(offset, n);
  if (depth <= 0.0L) return Vec3::Zero();
  const long double size = k * depth - d * dot(v, n);
  return static_cast<double>(std::max(size, 0.0L)) * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double dist = static_cast<double>(std::sqrt(dot(r, r)));  // the range of long double holds the squares
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  const long double size = k * (static_cast<long double>(R) - dist) - d * dot(v, n);
  return static_cast<double>(std::max(size, 0.0L)) * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  long double above = std::accumulate(m.begin(), m.end(), 0.0L);
  long double z = -above * g / kPlane;
  std::vector<double> result = {static_cast<double>(z)};
  for (std::size_t i = 1; i < m.size(); ++i) {
    above -= m[i - 1];
    z += L0 - above * g / k;
    result.push_back(static_cast<double>(z));
  }
  return result;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 t = v - static_cast<double>(dot(v, n)) * n;
  const long double speed = std::sqrt(dot(t, t));
  if (speed == 0.0L) return Vec3::Zero();
  const long double size = std::min<long double>(static_cast<long double>(mu) * N, c * speed);
  return static_cast<double>(-size / speed) * t;
}
