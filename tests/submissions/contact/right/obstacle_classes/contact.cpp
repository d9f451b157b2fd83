#include "contact.h"

namespace {

/// The length of a vector, also where the squares of its components vanish.
double length(const Vec3& a) {
  const double usual = a.norm();
  return usual > 1e-140 ? usual : a.stableNorm();
}

}  // namespace

namespace {

/// What a node has to know of an obstacle.
struct Obstacle {
  virtual ~Obstacle() = default;
  virtual double depth(const Vec3& x) const = 0;
  virtual Vec3 normal(const Vec3& x) const = 0;  // zero: none

  Vec3 force(const Vec3& x, const Vec3& v, double k, double d) const {
    const double inside = depth(x);
    if (inside <= 0.0) return Vec3::Zero();
    const Vec3 n = normal(x);
    return std::max(0.0, k * inside - d * n.dot(v)) * n;
  }
};

struct Plane final : Obstacle {
  Vec3 p, n;
  Plane(const Vec3& point, const Vec3& unit) : p(point), n(unit) {}
  double depth(const Vec3& x) const override { return n.dot(p - x); }
  Vec3 normal(const Vec3&) const override { return n; }
};

struct Sphere final : Obstacle {
  Vec3 c;
  double R;
  Sphere(const Vec3& centre, double radius) : c(centre), R(radius) {}
  double depth(const Vec3& x) const override { return R - length(x - c); }
  Vec3 normal(const Vec3& x) const override {
    const Vec3 r = x - c;
    if (r == Vec3::Zero()) return r;
    return r / length(r);
  }
};

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return Plane(p, n).force(x, v, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  return Sphere(c, R).force(x, v, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  // compression of what is under each node, from the top of the column to the bottom
  std::vector<double> squeeze;
  double load = 0.0;
  for (auto it = m.rbegin(); it != m.rend(); ++it) {
    load += *it * g;
    squeeze.push_back(load);
  }
  std::reverse(squeeze.begin(), squeeze.end());
  std::vector<double> z;
  for (double w : squeeze) {
    if (z.empty()) z.push_back(-w / kPlane);
    else z.push_back(z.back() + L0 - w / k);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 slip = v - n.dot(v) * n;
  const double speed = slip.stableNorm();
  if (speed == 0.0) return Vec3::Zero();
  const double size = std::min(c * speed, mu * N);
  return slip / speed * -size;
}
