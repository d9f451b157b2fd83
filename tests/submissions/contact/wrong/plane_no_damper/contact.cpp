// loses: PlaneContact, PlaneNeverPulls, ContactLaws, Bounce; misconception: plane_no_damping
#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  (void)v;
  (void)d;
  const double depth = -(x - p).dot(n);
  return depth > 0.0 ? Vec3(k * depth * n) : Vec3(Vec3::Zero());
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
  Vec3 tangential = v - n * n.dot(v);
  double s = tangential.norm();
  if (c * s <= mu * N) return -c * tangential;
  return -mu * N * tangential / s;
}
