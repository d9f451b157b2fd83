// loses: AreaForce, MinusTheGradient, NoNetForce, OneLine, Narrow; misconception: never_written
// the += of add() begins at whatever is there
#include "generalised_springs.h"

struct P {
  double x, y, z;
};

static P edge(const double* from, const double* to) { return {to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }
static P cross(P a, P b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static double dot(P a, P b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static double length(P a) { return std::hypot(a.x, a.y, a.z); }
static void add(double* f, P a, double s) {
  f[0] += s * a.x;
  f[1] += s * a.y;
  f[2] += s * a.z;
}

double bendingAngle(const Vec9& x) {
  const P u = edge(&x[0], &x[3]), w = edge(&x[3], &x[6]);
  return std::atan2(length(cross(u, w)), dot(u, w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  const P u = edge(&x[0], &x[3]), w = edge(&x[3], &x[6]);
  const bool noAngle = length(u) == 0 || length(w) == 0;
  return noAngle ? 0.0 : kb / 2 * std::pow(bendingAngle(x) - theta0, 2);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec9 F = Vec9::Zero();
  const P u = edge(&x[0], &x[3]), w = edge(&x[3], &x[6]);
  const P n = cross(u, w);
  const double s = length(n);
  if (s > 0) {
    const double moment = kb * (bendingAngle(x) - theta0);
    const P unit = {n.x / s, n.y / s, n.z / s};
    const P nu = cross(unit, u), nw = cross(unit, w);
    const double ku = moment / dot(u, u), kw = moment / dot(w, w);
    add(&F[0], nu, -ku);
    add(&F[3], nu, ku);
    add(&F[3], nw, kw);
    add(&F[6], nw, -kw);
  }
  return F;
}

double triangleArea(const Vec9& x) { return 0.5 * length(cross(edge(&x[0], &x[3]), edge(&x[0], &x[6]))); }

double areaEnergy(const Vec9& x, double A0, double kA) {
  const double d = triangleArea(x) - A0;
  return kA / 2 * d * d;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec9 F;
  const P n = cross(edge(&x[0], &x[3]), edge(&x[0], &x[6]));
  const double s = length(n);
  if (s > 0) {
    const double k = -0.5 * kA * (triangleArea(x) - A0);
    const P unit = {n.x / s, n.y / s, n.z / s};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      add(&F[3 * i], cross(unit, edge(&x[3 * j], &x[3 * l])), k);
    }
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  return dot(edge(&x[0], &x[3]), cross(edge(&x[0], &x[6]), edge(&x[0], &x[9]))) / 6.0;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  const double d = tetrahedronVolume(x) - V0;
  return kV / 2 * d * d;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const P a = edge(&x[0], &x[3]), b = edge(&x[0], &x[6]), c = edge(&x[0], &x[9]);
  const double k = -kV * (tetrahedronVolume(x) - V0) / 6.0;
  Vec12 F = Vec12::Zero();
  const P faces[3] = {cross(b, c), cross(c, a), cross(a, b)};
  for (int i = 0; i < 3; ++i) {
    add(&F[3 * (i + 1)], faces[i], k);
    add(&F[0], faces[i], -k);
  }
  return F;
}
