// loses: SpreadEnergy, MinusTheGradient; misconception: none
// spreadEnergy is a copy of meanHeightEnergy: it takes the mean height where the spread belongs.
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

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double d = meanHeight(x) - h0;
  return 0.5 * k * d * d;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F = VecX::Zero(x.size());
  const double n = x.size() / 3;
  for (Eigen::Index i = 2; i < x.size(); i += 3) F[i] = -k * (meanHeight(x) - h0) / n;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const Vec3 c = centreOfMass(x, m);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m.size(); ++i) sum += m[i] * (x.segment<3>(3 * i) - c).squaredNorm();
  return std::sqrt(sum / m.sum());
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
  (void)m;
  const double d = meanHeight(x) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return -k * (spread(x, m) - R0) * spreadGradient(x, m);
}
