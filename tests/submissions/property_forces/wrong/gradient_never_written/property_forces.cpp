// loses: OnePoint; misconception: never_written
// spreadGradient returns a vector that was never filled where all nodes are at one point: VecX gradient(size) is not
// zero by itself, VecX::Zero(size) is.
#include "property_forces.h"

static Vec3 centreOfMass(const VecX& x, const VecX& m) {
  Vec3 c = Vec3::Zero();
  for (Eigen::Index i = 0; i < m.size(); ++i) c += m[i] * x.segment<3>(3 * i);
  return c / m.sum();
}

double meanHeight(const VecX& x) {
  const int n = static_cast<int>(x.size()) / 3;
  double h = 0;
  for (int i = 0; i < n; i++) {
    h += x[3 * i + 2];
  }
  return h / n;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double d = meanHeight(x) - h0;
  return 0.5 * k * d * d;
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
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m.size(); ++i) sum += m[i] * (x.segment<3>(3 * i) - c).squaredNorm();
  return std::sqrt(sum / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX gradient(x.size());
  const double R = spread(x, m);
  if (R == 0) return gradient;  // no direction
  const Vec3 c = centreOfMass(x, m);
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    gradient.segment<3>(3 * i) = m[i] * (x.segment<3>(3 * i) - c) / (m.sum() * R);
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double d = spread(x, m) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double R = spread(x, m);
  VecX F = spreadGradient(x, m);
  F *= k * (R0 - R);
  return F;
}
