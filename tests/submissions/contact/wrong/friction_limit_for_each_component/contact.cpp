// loses: Friction, FrictionMotion; misconception: friction_by_components
#include "contact.h"

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
  std::vector<double> weight(m.size());
  double sum = 0;
  for (int i = (int)m.size() - 1; i >= 0; i--) {
    sum += m[i] * g;
    weight[i] = sum;
  }
  std::vector<double> z = {-weight[0] / kPlane};
  for (size_t i = 1; i < m.size(); i++) z.push_back(z[i - 1] + (L0 - weight[i] / k));
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double limit = mu * N;
  Vec3 F;
  for (int i = 0; i < 3; i++) F[i] = std::clamp(-c * vt[i], -limit, limit);
  return F;
}
