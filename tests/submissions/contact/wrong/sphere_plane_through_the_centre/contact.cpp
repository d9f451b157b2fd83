// loses: SphereContact, SphereEdges, ContactLaws, Bounce; misconception: zero
// the plane is put through c: no node is below it, the force is always zero
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = -(x - p).dot(n);
  if (depth <= 0.0) return Vec3::Zero();
  const double f = k * depth - d * v.dot(n);
  if (f <= 0.0) return Vec3::Zero();
  return f * n;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  (void)R;
  const double dist = (x - c).norm();
  if (dist == 0.0) return Vec3::Zero();
  return planeContact(x, v, c, (x - c) / dist, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  double above = 0.0;
  for (double mi : m) above += mi;
  std::vector<double> z;
  z.push_back(-above * g / kPlane);
  for (std::size_t i = 1; i < m.size(); ++i) {
    above -= m[i - 1];
    z.push_back(z.back() + L0 - above * g / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 vt = v;
  vt -= vt.dot(n) * n;
  double vtNorm = vt.norm();
  if (vtNorm > 0) {
    double size = c * vtNorm < mu * N ? c * vtNorm : mu * N;
    return vt * (-size / vtNorm);
  }
  return Vec3::Zero();
}
