// loses: SphereContact, Bounce; misconception: sphere_difference_of_squares
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double delta = (p - x).dot(n);
  double vn = v.dot(n);
  Vec3 F(0, 0, 0);
  if (delta > 0) {
    F = std::max(0.0, k * delta - d * vn) * n;
  }
  return F;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const Vec3 r = x - c;
  const double depth = R * R - r.squaredNorm();
  if (depth <= 0 || r.norm() == 0) return Vec3::Zero();
  const Vec3 n = r / r.norm();
  return std::max(0.0, k * depth - d * v.dot(n)) * n;
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
