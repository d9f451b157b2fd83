#include "generalised_springs.h"

// No cross product of Eigen's: components.
namespace {

using V = std::array<double, 3>;

template <class Vector>
V edge(const Vector& x, int from, int to) {
  return {x[3 * to] - x[3 * from], x[3 * to + 1] - x[3 * from + 1], x[3 * to + 2] - x[3 * from + 2]};
}
V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const V& a) { return std::hypot(a[0], a[1], a[2]); }

template <class Vector>
void push(Vector& F, int node, const V& way, double factor) {
  for (int i = 0; i < 3; ++i) F[3 * node + i] += factor * way[static_cast<std::size_t>(i)];
}

}  // namespace

double bendingAngle(const Vec9& x) {
  const V u = edge(x, 0, 1), w = edge(x, 1, 2);
  return std::atan2(length(cross(u, w)), dot(u, w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  if (length(edge(x, 0, 1)) == 0 || length(edge(x, 1, 2)) == 0) return 0;
  const double off = theta0 - bendingAngle(x);
  return off * off * kb / 2;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec9 F = Vec9::Zero();
  const V u = edge(x, 0, 1), w = edge(x, 1, 2);
  V n = cross(u, w);
  const double s = length(n);
  if (s == 0) return F;
  for (double& each : n) each /= s;
  const double torque = kb * (theta0 - bendingAngle(x));
  push(F, 0, cross(n, u), torque / dot(u, u));
  push(F, 1, cross(n, u), -torque / dot(u, u));
  push(F, 1, cross(n, w), -torque / dot(w, w));
  push(F, 2, cross(n, w), torque / dot(w, w));
  return F;
}

double triangleArea(const Vec9& x) { return length(cross(edge(x, 0, 1), edge(x, 0, 2))) / 2; }

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double off = A0 - triangleArea(x);
  return off * off * kA / 2;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec9 F = Vec9::Zero();
  V n = cross(edge(x, 0, 1), edge(x, 0, 2));
  const double s = length(n);
  if (s == 0) return F;
  for (double& each : n) each /= s;
  const double pressure = kA * (A0 - triangleArea(x));
  push(F, 0, cross(n, edge(x, 1, 2)), pressure / 2);
  push(F, 1, cross(n, edge(x, 2, 0)), pressure / 2);
  push(F, 2, cross(n, edge(x, 0, 1)), pressure / 2);
  return F;
}

double tetrahedronVolume(const Vec12& x) { return dot(cross(edge(x, 0, 1), edge(x, 0, 2)), edge(x, 0, 3)) / 6; }

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double off = V0 - tetrahedronVolume(x);
  return off * off * kV / 2;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  Vec12 F = Vec12::Zero();
  const double pressure = kV * (V0 - tetrahedronVolume(x)) / 6;
  const V a = edge(x, 0, 1), b = edge(x, 0, 2), c = edge(x, 0, 3);
  const V faces[] = {cross(b, c), cross(c, a), cross(a, b)};
  for (int i = 0; i < 3; ++i) {
    push(F, i + 1, faces[i], pressure);
    push(F, 0, faces[i], -pressure);
  }
  return F;
}
