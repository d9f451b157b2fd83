#include "contact.h"

#include <numeric>
#include <optional>

struct Hit {
  double depth;
  Vec3 normal;
};

static std::optional<Hit> hitPlane(const Vec3& x, const Vec3& p, const Vec3& n) {
  const double depth = -(x - p).dot(n);
  if (depth > 0) return Hit{depth, n};
  return std::nullopt;
}

static std::optional<Hit> hitSphere(const Vec3& x, const Vec3& c, double R) {
  const Vec3 r = x - c;
  const double dist = std::hypot(r.x(), r.y(), r.z());
  if (dist > 0 && dist < R) return Hit{R - dist, r / dist};
  return std::nullopt;
}

static Vec3 respond(const std::optional<Hit>& hit, const Vec3& v, double k, double d) {
  if (!hit) return Vec3::Zero();
  const auto& [depth, normal] = *hit;
  const double vn = v.dot(normal);
  return std::max(k * depth - d * vn, 0.0) * normal;
}

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  return respond(hitPlane(x, p, n), v, k, d);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  return respond(hitSphere(x, c, R), v, k, d);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z;
  for (auto it = m.begin(); it != m.end(); ++it) {
    const double weight = g * std::accumulate(it, m.end(), 0.0);
    z.push_back(z.empty() ? -weight / kPlane : z.back() - weight / k + L0);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 vt = v - v.dot(n) * n;
  const double limit = mu * N;
  const Vec3 viscous = -c * vt;
  const double size = viscous.stableNorm();
  if (size <= limit) return viscous;
  return viscous * (limit / size);
}
