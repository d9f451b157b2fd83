// loses: TetrahedronVolume; misconception: a_third or doubled
// tetrahedronVolume divides the triple product by three: base times height over three, with the parallelogram for the
// base.
#include "generalised_springs.h"

namespace {

struct P {
  double x, y, z;
};

P minus(P a, P b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
P cross(P a, P b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double dot(P a, P b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double len(P a) { return std::sqrt(dot(a, a)); }
P scale(double s, P a) { return {s * a.x, s * a.y, s * a.z}; }

template <class V>
P get(const V& v, int i) {
  return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
}

template <class V>
void add(V& v, int i, P a) {
  v[3 * i] += a.x;
  v[3 * i + 1] += a.y;
  v[3 * i + 2] += a.z;
}

}  // namespace

double bendingAngle(const Vec9& x) {
  P u = minus(get(x, 1), get(x, 0));
  P w = minus(get(x, 2), get(x, 1));
  if (len(u) == 0 || len(w) == 0) return 0;
  return std::atan2(len(cross(u, w)), dot(u, w));
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  P u = minus(get(x, 1), get(x, 0));
  P w = minus(get(x, 2), get(x, 1));
  if (len(u) == 0) return 0;
  if (len(w) == 0) return 0;
  double t = bendingAngle(x);
  return 0.5 * kb * (t - theta0) * (t - theta0);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  Vec9 f = Vec9::Zero();
  P u = minus(get(x, 1), get(x, 0));
  P w = minus(get(x, 2), get(x, 1));
  P n = cross(u, w);
  double nn = len(n);
  if (nn == 0) return f;
  n = scale(1 / nn, n);
  double moment = -kb * (bendingAngle(x) - theta0);
  P fu = scale(-moment / dot(u, u), cross(n, u));
  P fw = scale(moment / dot(w, w), cross(n, w));
  // u = x1 - x0
  add(f, 1, fu);
  add(f, 0, scale(-1, fu));
  // w = x2 - x1
  add(f, 2, fw);
  add(f, 1, scale(-1, fw));
  return f;
}

double triangleArea(const Vec9& x) {
  P u = minus(get(x, 1), get(x, 0));
  P w = minus(get(x, 2), get(x, 0));
  return 0.5 * len(cross(u, w));
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  double A = triangleArea(x);
  return 0.5 * kA * (A - A0) * (A - A0);
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  Vec9 f = Vec9::Zero();
  P u = minus(get(x, 1), get(x, 0));
  P w = minus(get(x, 2), get(x, 0));
  P v = minus(get(x, 2), get(x, 1));
  P n = cross(u, w);
  double nn = len(n);
  if (nn == 0) return f;
  n = scale(1 / nn, n);
  double s = -0.5 * kA * (triangleArea(x) - A0);
  add(f, 0, scale(s, cross(n, v)));
  add(f, 1, scale(-s, cross(n, w)));
  add(f, 2, scale(s, cross(n, u)));
  return f;
}

double tetrahedronVolume(const Vec12& x) {
  P a = minus(get(x, 1), get(x, 0));
  P b = minus(get(x, 2), get(x, 0));
  P c = minus(get(x, 3), get(x, 0));
  return dot(a, cross(b, c)) / 3.0;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  double V = tetrahedronVolume(x);
  return 0.5 * kV * (V - V0) * (V - V0);
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  Vec12 f = Vec12::Zero();
  P a = minus(get(x, 1), get(x, 0));
  P b = minus(get(x, 2), get(x, 0));
  P c = minus(get(x, 3), get(x, 0));
  double s = -kV * (tetrahedronVolume(x) - V0) / 6.0;
  P f1 = scale(s, cross(b, c));
  P f2 = scale(s, cross(c, a));
  P f3 = scale(s, cross(a, b));
  add(f, 1, f1);
  add(f, 2, f2);
  add(f, 3, f3);
  add(f, 0, scale(-1, f1));
  add(f, 0, scale(-1, f2));
  add(f, 0, scale(-1, f3));
  return f;
}
