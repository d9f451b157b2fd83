// loses: SpreadForce, MinusTheGradient; misconception: wrong_sign
// spreadForce lacks the minus: it is the gradient of the energy and leads away from the target.
#include "property_forces.h"

static Vec3 centreOfMass(const VecX& x, const VecX& m) {
  Vec3 c = Vec3::Zero();
  for (Eigen::Index i = 0; i < m.size(); ++i) c += m[i] * x.segment<3>(3 * i);
  return c / m.sum();
}

double meanHeight(const VecX& x) {
  double sum = 0.0;
  for (Eigen::Index i = 2; i < x.size(); i += 3) sum += x[i];
  return sum / (x.size() / 3);
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return k / 2 * std::pow(meanHeight(x) - h0, 2); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F = VecX::Zero(x.size());
  const double n = x.size() / 3;
  for (Eigen::Index i = 2; i < x.size(); i += 3) F[i] = -k * (meanHeight(x) - h0) / n;
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
  VecX gradient = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (R == 0) return gradient;
  const Vec3 c = centreOfMass(x, m);
  const double M = m.sum();
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    gradient.segment<3>(3 * i) = m[i] / M * (x.segment<3>(3 * i) - c) / R;
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return k / 2 * std::pow(spread(x, m) - R0, 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double R = spread(x, m);
  return k * (R - R0) * spreadGradient(x, m);
}
