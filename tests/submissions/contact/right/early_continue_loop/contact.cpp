#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double distance = (x - p).dot(n);  // signed, positive outside
  if (distance > 0 || distance == 0) return Vec3::Zero();
  const double vn = v.dot(n);
  const double elastic = k * std::abs(distance);
  const double viscous = -d * vn;
  const double total = elastic + viscous;
  if (total < 0) return Vec3::Zero();
  return n * total;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  const double distance = std::hypot(x.x() - c.x(), x.y() - c.y(), x.z() - c.z());
  if (distance >= R) return Vec3::Zero();
  if (distance == 0) return Vec3::Zero();
  // the plane through the node itself carries the damper; the push is that of the depth
  Vec3 n = (x - c);
  n = n / distance;
  double total = k * (R - distance);
  total -= d * n.x() * v.x();
  total -= d * n.y() * v.y();
  total -= d * n.z() * v.z();
  if (total < 0) return Vec3::Zero();
  return n * total;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z;
  z.reserve(m.size());
  double height = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    double load = 0;
    for (std::size_t j = 0; j < m.size(); ++j) {
      if (j < i) continue;
      load += m[j];
    }
    load *= g;
    if (i == 0) {
      height = -load / kPlane;
    } else {
      const double length = L0 - load / k;
      height += length;
    }
    z.push_back(height);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const double vn = v.dot(n);
  const Vec3 vt(v.x() - vn * n.x(), v.y() - vn * n.y(), v.z() - vn * n.z());
  if (vt == Vec3::Zero()) return vt;
  const double speed = vt.stableNorm();
  const Vec3 direction = vt / speed;
  return -std::min({mu * N, c * speed}) * direction;
}
