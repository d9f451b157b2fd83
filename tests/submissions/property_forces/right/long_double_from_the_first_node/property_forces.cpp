#include "property_forces.h"

typedef long double Big;

// Positions as seen from the centre of mass. Counted from node 0 first, so that a far class keeps its digits.
static std::vector<Big> seenFromCentre(const VecX& x, const VecX& m) {
  const long n = m.size();
  std::vector<Big> d(3 * n);
  for (int axis = 0; axis < 3; ++axis) {
    Big sum = 0, mass = 0;
    for (long i = 0; i < n; ++i) {
      d[3 * i + axis] = Big(x[3 * i + axis]) - Big(x[axis]);
      sum += m[i] * d[3 * i + axis];
      mass += m[i];
    }
    for (long i = 0; i < n; ++i) d[3 * i + axis] -= sum / mass;
  }
  return d;
}

static Big bigSpread(const VecX& x, const VecX& m) {
  const std::vector<Big> d = seenFromCentre(x, m);
  Big squares = 0, mass = 0;
  for (long i = 0; i < m.size(); ++i) {
    mass += m[i];
    for (int axis = 0; axis < 3; ++axis) squares += m[i] * d[3 * i + axis] * d[3 * i + axis];
  }
  return std::sqrt(squares / mass);
}

double meanHeight(const VecX& x) {
  Big sum = 0;
  for (long i = 2; i < x.size(); i += 3) sum += x[i];
  return static_cast<double>(3 * sum / x.size());
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const Big d = Big(meanHeight(x)) - h0;
  return static_cast<double>(d * d * k / 2);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F = VecX::Zero(x.size());
  for (long i = 0; i < x.size(); ++i) {
    if (i % 3 == 2) F[i] = -3 * k * (meanHeight(x) - h0) / x.size();
  }
  return F;
}

double spread(const VecX& x, const VecX& m) { return static_cast<double>(bigSpread(x, m)); }

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  const Big R = bigSpread(x, m);
  if (R == 0) return g;
  const std::vector<Big> d = seenFromCentre(x, m);
  Big mass = 0;
  for (double one : m) mass += one;
  for (long i = 0; i < x.size(); ++i) g[i] = static_cast<double>(m[i / 3] * d[i] / (mass * R));
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const Big d = bigSpread(x, m) - R0;
  return static_cast<double>(d * d * k / 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double s = static_cast<double>(k * (R0 - bigSpread(x, m)));
  VecX F = spreadGradient(x, m);
  for (double& f : F) f *= s;
  return F;
}
