// loses: MeanHeight; misconception: divided_by_components
// meanHeight divides the sum of the heights by the number of components, 3n, instead of the number of nodes.
#include "property_forces.h"

double meanHeight(const VecX& x) {
  const int n = (int)x.size() / 3;
  double h = 0;
  for (int i = 0; i < n; i++) h += x[3 * i + 2] / x.size();
  return h;
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return k * std::pow(meanHeight(x) - h0, 2) / 2; }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = (int)x.size() / 3;
  VecX F = VecX::Zero(x.size());
  const double f = k * (h0 - meanHeight(x)) / n;
  for (int i = 0; i < n; i++) F[3 * i + 2] = f;
  return F;
}

// M^2 R^2 = sum over all pairs of mi mj |xi - xj|^2
double spread(const VecX& x, const VecX& m) {
  const int n = (int)m.size();
  double sum = 0, M = 0;
  for (int i = 0; i < n; i++) {
    M += m[i];
    for (int j = 0; j < i; j++) {
      const Vec3 d = x.segment<3>(3 * i) - x.segment<3>(3 * j);
      sum += m[i] * m[j] * d.squaredNorm();
    }
  }
  return std::sqrt(sum) / M;
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const int n = (int)m.size();
  VecX g = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (R == 0) return g;
  const double M = m.sum();
  for (int i = 0; i < n; i++) {
    Vec3 pull = Vec3::Zero();
    for (int j = 0; j < n; j++) {
      pull += m[j] * (x.segment<3>(3 * i) - x.segment<3>(3 * j));
    }
    g.segment<3>(3 * i) = m[i] * pull / (M * M * R);
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return k * std::pow(spread(x, m) - R0, 2) / 2;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  VecX F = spreadGradient(x, m);
  F *= k * (R0 - spread(x, m));
  return F;
}
