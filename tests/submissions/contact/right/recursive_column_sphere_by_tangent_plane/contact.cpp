#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = n.dot(p - x);
  const double f = depth > 0 ? k * depth - d * n.dot(v) : 0.0;
  return f > 0 ? Vec3(f * n) : Vec3(Vec3::Zero());
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  if (x == c) return Vec3::Zero();
  const Vec3 n = (x - c).stableNormalized();
  // The plane that touches the sphere above the node, in a frame along n: the depth is its height over the node.
  const Vec3 down = Vec3::UnitZ() * ((x - c).norm() - R);
  const Vec3 velocity = Vec3::UnitZ() * n.dot(v);
  return planeContact(down, velocity, Vec3::Zero(), Vec3::UnitZ(), k, d).z() * n;
}

namespace {

// Writes the weight of each node and those above it, for node i and all above, and returns that of node i.
double visit(const std::vector<double>& m, double g, std::size_t i, std::vector<double>& load) {
  if (i == m.size()) return 0.0;
  const double above = visit(m, g, i + 1, load);
  return load[i] = above + m[i] * g;
}

}  // namespace

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z(m.size());
  visit(m, g, 0, z);
  z[0] = -(z[0] / kPlane);
  for (std::size_t i = 1; i < z.size(); ++i) z[i] = z[i - 1] + (L0 - z[i] / k);
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 along = v - n.dot(v) * n;
  if (along == Vec3::Zero()) return Vec3::Zero();
  const Vec3 viscous = -c * along;
  const double limit = mu * N;
  if (viscous.stableNorm() <= limit) return viscous;
  return -limit * along.stableNormalized();
}
