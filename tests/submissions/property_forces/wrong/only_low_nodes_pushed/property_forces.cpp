// loses: MeanHeightForce, MinusTheGradient, SwingingClass; misconception: none
// meanHeightForce pushes only the nodes that are on the same side of h0 as the mean: the gradient of the mean is 1/n
// for every node, wherever it is.
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
  double sum = 0.0;
  for (Eigen::Index i = 2; i < x.size(); i += 3) sum += x[i];
  return sum / (x.size() / 3);
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return k / 2 * std::pow(meanHeight(x) - h0, 2); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = static_cast<int>(x.size()) / 3;
  const double d = meanHeight(x) - h0;
  VecX F = VecX::Zero(x.size());
  for (int i = 0; i < n; i++) {
    const double z = x[3 * i + 2];
    // who is on the right side of h0 already need not be moved
    if ((d < 0 && z < h0) || (d > 0 && z > h0)) F[3 * i + 2] = -k * d / n;
  }
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
  return -k * (spread(x, m) - R0) * spreadGradient(x, m);
}
