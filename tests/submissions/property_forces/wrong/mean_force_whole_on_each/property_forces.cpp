// loses: MeanHeightForce, MinusTheGradient, SwingingClass; misconception: missing_share
#include "property_forces.h"

using Cloud = Eigen::Matrix<double, 3, Eigen::Dynamic>;

namespace {
Cloud cloudOf(const VecX& x) { return Eigen::Map<const Cloud>(x.data(), 3, x.size() / 3); }

Cloud aroundCentre(const VecX& x, const VecX& m) {
  Cloud X = cloudOf(x);
  const Vec3 c = (X * m) / m.sum();
  X.colwise() -= c;
  return X;
}
}  // namespace

double meanHeight(const VecX& x) { return cloudOf(x).row(2).mean(); }

double meanHeightEnergy(const VecX& x, double h0, double k) { return k / 2 * std::pow(meanHeight(x) - h0, 2); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  Cloud F = Cloud::Zero(3, x.size() / 3);
  F.row(2).setConstant(k * (h0 - meanHeight(x)));
  return Eigen::Map<const VecX>(F.data(), F.size());
}

double spread(const VecX& x, const VecX& m) {
  const Cloud D = aroundCentre(x, m);
  return std::sqrt(D.colwise().squaredNorm().dot(m.transpose()) / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  Cloud G = aroundCentre(x, m);
  if (R == 0.0) return VecX::Zero(x.size());
  G = (G / R) * (m / m.sum()).asDiagonal();
  return Eigen::Map<const VecX>(G.data(), G.size());
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return k / 2 * std::pow(spread(x, m) - R0, 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return k * (R0 - spread(x, m)) * spreadGradient(x, m);
}
