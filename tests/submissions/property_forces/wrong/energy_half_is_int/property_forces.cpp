// loses: MeanHeightEnergy, MinusTheGradient; misconception: integer_division
// meanHeightEnergy multiplies by (1 / 2), an integer division that gives 0, so the energy is always zero.
#include "property_forces.h"

namespace {

Vec3 centreOfMass(const VecX& x, const VecX& m) {
  Vec3 sum = Vec3::Zero();
  double M = 0.0;
  for (int i = 0; i < m.size(); i++) {
    sum += m[i] * x.segment<3>(3 * i);
    M += m[i];
  }
  return sum / M;
}

}  // namespace

double meanHeight(const VecX& x) {
  const int n = static_cast<int>(x.size()) / 3;
  double h = 0;
  for (int i = 0; i < n; i++) {
    h += x[3 * i + 2];
  }
  return h / n;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double h = meanHeight(x);
  return (1 / 2) * k * (h - h0) * (h - h0);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = static_cast<int>(x.size()) / 3;
  const double each = -k * (meanHeight(x) - h0) * (1.0 / n);
  VecX F = VecX::Zero(x.size());
  for (int i = 0; i < n; i++) F[3 * i + 2] = each;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const Vec3 c = centreOfMass(x, m);
  double R2 = 0.0, M = 0.0;
  for (int i = 0; i < m.size(); i++) {
    const Vec3 r = x.segment<3>(3 * i) - c;
    R2 += m[i] * r.dot(r);
    M += m[i];
  }
  return std::sqrt(R2 / M);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m), M = m.sum();
  const Vec3 c = centreOfMass(x, m);
  VecX g = VecX::Zero(x.size());
  if (R > 0) {
    for (int i = 0; i < m.size(); i++) {
      const Vec3 outwards = (x.segment<3>(3 * i) - c) / R;
      g.segment<3>(3 * i) = (m[i] / M) * outwards;
    }
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return k / 2 * std::pow(spread(x, m) - R0, 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double R = spread(x, m);
  VecX F = spreadGradient(x, m);
  F *= k * (R0 - R);
  return F;
}
