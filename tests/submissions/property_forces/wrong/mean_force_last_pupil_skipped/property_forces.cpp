// loses: MeanHeightForce, MinusTheGradient, Equivariance, SwingingClass; misconception: last_skipped
#include "property_forces.h"

// R^2 = sum over pairs of mi mj |xi - xj|^2 / M^2: no centre is needed at all

static Vec3 between(const VecX& x, Eigen::Index i, Eigen::Index j) {
  return x.segment<3>(3 * i) - x.segment<3>(3 * j);
}

double meanHeight(const VecX& x) {
  double total = 0.0;
  Eigen::Index count = 0;
  for (Eigen::Index z = 2; z < x.size(); z += 3, ++count) total += x(z);
  return total / static_cast<double>(count);
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double above = meanHeight(x) - h0;
  return k * above * above / 2.0;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const double n = static_cast<double>(x.size()) / 3.0;
  VecX F = VecX::Zero(x.size());
  for (Eigen::Index z = 2; z < x.size() - 3; z += 3) F(z) = -k * (meanHeight(x) - h0) / n;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) sum += m(i) * m(j) * between(x, i, j).squaredNorm();
  }
  return std::sqrt(sum) / m.sum();
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  const double R = spread(x, m), M = m.sum();
  if (R == 0.0) return g;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (Eigen::Index j = 0; j < m.size(); ++j) g.segment<3>(3 * i) += (m(i) / M) * (m(j) / M) * (between(x, i, j) / R);
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double wider = spread(x, m) - R0;
  return k * wider * wider / 2.0;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double tension = k * (spread(x, m) - R0);
  return -tension * spreadGradient(x, m);
}
