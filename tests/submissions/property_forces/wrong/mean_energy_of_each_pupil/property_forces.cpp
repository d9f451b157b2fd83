// loses: MeanHeightEnergy, MinusTheGradient; misconception: each_by_itself
#include "property_forces.h"

static void centre(const VecX& x, const VecX& m, double c[3]) {
  double total = 0;
  c[0] = c[1] = c[2] = 0;
  for (int i = 0; i < m.size(); i++) {
    total += m[i];
    for (int j = 0; j < 3; j++) c[j] += m[i] * x[3 * i + j];
  }
  for (int j = 0; j < 3; j++) c[j] /= total;
}

double meanHeight(const VecX& x) {
  int n = x.size() / 3;
  double sum = 0;
  for (int i = 0; i < n; i++) sum += x[3 * i + 2];
  return sum / n;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  int n = x.size() / 3;
  double E = 0;
  for (int i = 0; i < n; i++) E += 0.5 * k * (x[3 * i + 2] - h0) * (x[3 * i + 2] - h0);
  return E / n;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  int n = x.size() / 3;
  double f = -k * (meanHeight(x) - h0) / n;
  VecX F(x.size());
  for (int i = 0; i < n; i++) {
    F[3 * i] = 0;
    F[3 * i + 1] = 0;
    F[3 * i + 2] = f;
  }
  return F;
}

double spread(const VecX& x, const VecX& m) {
  double c[3];
  centre(x, m, c);
  double sum = 0, total = 0;
  for (int i = 0; i < m.size(); i++) {
    double dx = x[3 * i] - c[0], dy = x[3 * i + 1] - c[1], dz = x[3 * i + 2] - c[2];
    sum += m[i] * (dx * dx + dy * dy + dz * dz);
    total += m[i];
  }
  return sqrt(sum / total);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  double R = spread(x, m);
  if (R > 0) {
    double c[3];
    centre(x, m, c);
    double total = m.sum();
    for (int i = 0; i < m.size(); i++) {
      for (int j = 0; j < 3; j++) g[3 * i + j] = m[i] / total * ((x[3 * i + j] - c[j]) / R);
    }
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  double d = spread(x, m) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  VecX F = spreadGradient(x, m);
  double s = -k * (spread(x, m) - R0);
  for (int i = 0; i < F.size(); i++) F[i] *= s;
  return F;
}
