#include "contact.h"

namespace {

using Q = long double;
struct Q3 {
  Q x, y, z;
};

Q3 wide(const Vec3& a) { return {a[0], a[1], a[2]}; }
Q3 operator-(Q3 a, Q3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Q3 operator*(Q f, Q3 a) { return {f * a.x, f * a.y, f * a.z}; }
Q dot(Q3 a, Q3 b) { return a.z * b.z + a.y * b.y + a.x * b.x; }
Q3 cross(Q3 a, Q3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec3 narrow(Q3 a) { return Vec3(double(a.x), double(a.y), double(a.z)); }

Vec3 obstacle(Q depth, Q3 v, Q3 n, Q k, Q d) {
  if (depth <= 0) return Vec3::Zero();
  return narrow(std::max<Q>(0, k * depth - d * dot(v, n)) * n);
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return obstacle(dot(wide(p) - wide(x), wide(n)), wide(v), wide(n), k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Q3 r = wide(x) - wide(c);
  const Q distance = std::sqrt(dot(r, r));
  if (distance == 0) return Vec3::Zero();
  return obstacle(R - distance, wide(v), (1 / distance) * r, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  Q carried = 0;
  for (auto top = m.rbegin(); top != m.rend(); ++top) carried += *top;
  Q height = -carried * g / kPlane;
  std::vector<double> z(1, double(height));
  for (std::size_t i = 0; i + 1 < m.size(); ++i) {
    carried -= m[i];
    height += L0 - carried * g / k;
    z.push_back(double(height));
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Q3 normal = wide(n);
  const Q3 vt = cross(normal, cross(wide(v), normal));  // n x (v x n) = v - (v . n) n
  const Q speed = std::sqrt(dot(vt, vt));
  if (speed == 0) return Vec3::Zero();
  return narrow(-std::min<Q>(Q(mu) * N, c * speed) / speed * vt);
}
