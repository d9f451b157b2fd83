// loses: SpreadGradient, OnePoint, TinySpread; misconception: difference_quotient
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
  double d = meanHeight(x) - h0;
  return 0.5 * k * d * d;
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
  const double h = 1e-6;
  VecX g = VecX::Zero(x.size()), y = x;
  for (int i = 0; i < x.size(); i++) {
    y[i] = x[i] + h;
    double more = spread(y, m);
    y[i] = x[i] - h;
    double less = spread(y, m);
    y[i] = x[i];
    g[i] = (more - less) / (2 * h);
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
