// loses: ColumnAtRest; misconception: whole_numbers or integer_division
#include "contact.h"

#include <numeric>

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double inside = n.dot(p - x);
  return inside > 0 ? Vec3(std::max(k * inside - d * n.dot(v), 0.0) * n) : Vec3(0, 0, 0);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dist = std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]);
  if (dist == 0) return Vec3::Zero();
  Vec3 n = (x - c) / dist;
  double delta = R - dist;
  if (delta <= 0) return Vec3::Zero();
  double f = k * delta - d * v.dot(n);
  if (f < 0) f = 0;
  return f * n;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z;
  for (auto it = m.begin(); it != m.end(); ++it) {
    const double load = std::accumulate(it, m.end(), 0) * g;
    z.push_back(it == m.begin() ? -load / kPlane : z.back() + L0 - load / k);
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
