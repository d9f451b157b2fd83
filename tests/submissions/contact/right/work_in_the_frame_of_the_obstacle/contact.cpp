#include "contact.h"

static double len(const Vec3& r) { return std::hypot(r.x(), r.y(), r.z()); }

namespace {

struct Frame {
  double depth;
  double closing;  // how fast the depth grows
};

double strength(const Frame& f, double k, double d) {
  if (f.depth <= 0) return 0;
  const double s = k * f.depth + d * f.closing;
  return s > 0 ? s : 0;
}

}  // namespace

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const Vec3 into = -n;
  const Frame frame{into.dot(x - p), into.dot(v)};
  return -strength(frame, k, d) * into;
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  Vec3 into = c - x;
  const double toCentre = len(into);
  if (toCentre == 0) return Vec3::Zero();
  into /= toCentre;
  const Frame frame{R - toCentre, into.dot(v)};
  return -strength(frame, k, d) * into;
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  double total = 0;
  for (auto mass : m) total += mass;
  double done = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double load = (total - done) * g;
    z[i] = i ? z[i - 1] + L0 - load / k : -load / kPlane;
    done += m[i];
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  Vec3 t = v;
  t -= t.dot(n) * n;
  const double speed = t.stableNorm();
  if (speed > 0) {
    t /= speed;
    t *= -std::min(mu * N, c * speed);
  }
  return t;
}
