#include "property_forces.h"

namespace {

int count(const VecX& x) { return static_cast<int>(x.size()) / 3; }

Vec3 centreOfMass(const VecX& x, const VecX& m) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < m.size(); ++i) sum += m[i] * x.segment<3>(3 * i);
  return sum / m.sum();
}

}  // namespace

double meanHeight(const VecX& x) {
  double sum = 0.0;
  for (int i = 2; i < x.size(); i += 3) sum += x[i];
  return sum / count(x);
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double away = meanHeight(x) - h0;
  return 0.5 * k * away * away;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const double share = 1.0 / count(x);  // the mean rises by this part of what one node rises
  VecX F = VecX::Zero(x.size());
  for (int i = 2; i < x.size(); i += 3) F[i] = -k * (meanHeight(x) - h0) * share;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const Vec3 c = centreOfMass(x, m);
  double sum = 0.0;
  for (int i = 0; i < m.size(); ++i) sum += m[i] * (x.segment<3>(3 * i) - c).squaredNorm();
  return std::sqrt(sum / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  VecX gradient = VecX::Zero(x.size());
  if (R == 0) return gradient;
  const Vec3 c = centreOfMass(x, m);  // it moves with every node, but that cancels in the sum
  for (int i = 0; i < m.size(); ++i) gradient.segment<3>(3 * i) = m[i] * (x.segment<3>(3 * i) - c) / (m.sum() * R);
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double away = spread(x, m) - R0;
  return 0.5 * k * away * away;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return -k * (spread(x, m) - R0) * spreadGradient(x, m);
}
