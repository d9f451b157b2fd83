#include "property_forces.h"

// Every sum in long double; the force of the spread does not ask the gradient.
namespace {

using Long = long double;
struct Point {
  Long x = 0, y = 0, z = 0;
};

Point nodeAt(const VecX& x, Eigen::Index i) { return {x[3 * i], x[3 * i + 1], x[3 * i + 2]}; }

Point centreOf(const VecX& x, const VecX& m) {
  Point c;
  Long M = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Point p = nodeAt(x, i);
    c.x += m[i] * p.x;
    c.y += m[i] * p.y;
    c.z += m[i] * p.z;
    M += m[i];
  }
  return {c.x / M, c.y / M, c.z / M};
}

Long massOf(const VecX& m) {
  Long M = 0;
  for (const double each : m) M += each;
  return M;
}

Long radius(const VecX& x, const VecX& m) {
  const Point c = centreOf(x, m);
  Long sum = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Point p = nodeAt(x, i);
    sum += m[i] * ((p.x - c.x) * (p.x - c.x) + (p.y - c.y) * (p.y - c.y) + (p.z - c.z) * (p.z - c.z));
  }
  return sqrtl(sum / massOf(m));
}

/// The gradient of the spread times a factor.
VecX outwards(const VecX& x, const VecX& m, Long factor) {
  const Point c = centreOf(x, m);
  const Long R = radius(x, m);
  VecX out = VecX::Zero(x.size());
  if (R == 0) return out;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Point p = nodeAt(x, i);
    const Long share = factor * m[i] / massOf(m) / R;
    out.segment<3>(3 * i) << static_cast<double>(share * (p.x - c.x)), static_cast<double>(share * (p.y - c.y)),
        static_cast<double>(share * (p.z - c.z));
  }
  return out;
}

Long height(const VecX& x) {
  Long sum = 0;
  for (Eigen::Index i = 2; i < x.size(); i += 3) sum += x[i];
  return sum / (x.size() / 3);
}

}  // namespace

double meanHeight(const VecX& x) { return static_cast<double>(height(x)); }

double meanHeightEnergy(const VecX& x, double h0, double k) {
  return static_cast<double>(k * (height(x) - h0) * (height(x) - h0) / 2);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F = VecX::Zero(x.size());
  for (Eigen::Index i = 2; i < x.size(); i += 3) F[i] = static_cast<double>(k * (h0 - height(x)) / (x.size() / 3));
  return F;
}

double spread(const VecX& x, const VecX& m) { return static_cast<double>(radius(x, m)); }
VecX spreadGradient(const VecX& x, const VecX& m) { return outwards(x, m, 1); }

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return static_cast<double>(k * (radius(x, m) - R0) * (radius(x, m) - R0) / 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) { return outwards(x, m, k * (R0 - radius(x, m))); }
