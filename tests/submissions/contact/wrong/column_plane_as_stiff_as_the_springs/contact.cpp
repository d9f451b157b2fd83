// loses: ColumnAtRest; misconception: swapped_arguments
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
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist == 0.0 || dist >= R) return Vec3::Zero();
  const Vec3 n = r / dist;
  return std::max(0.0, k * (R - dist) - d * v.dot(n)) * n;
}

static std::vector<double> heights(const std::vector<double>& m, double kPlane, double L0, double k, double g) {
  double load = 0;
  for (double mi : m) load += mi * g;
  std::vector<double> z;
  for (std::size_t i = 0; i < m.size(); i++) {
    z.push_back(i == 0 ? -load / kPlane : z[i - 1] + L0 - load / k);
    load -= m[i] * g;
  }
  return z;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  return heights(m, k, L0, kPlane, g);
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
