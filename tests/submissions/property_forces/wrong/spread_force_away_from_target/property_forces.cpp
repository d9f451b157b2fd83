// loses: SpreadForce, MinusTheGradient; misconception: wrong_sign
// spreadForce forgets the minus of the negative gradient.
#include "property_forces.h"

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic>;

static Columns columns(const VecX& x) { return Eigen::Map<const Columns>(x.data(), 3, x.size() / 3); }

static Columns fromCentre(const VecX& x, const VecX& m) {
  const Columns X = columns(x);
  const Vec3 c = X * m / m.sum();
  return X.colwise() - c;
}

double meanHeight(const VecX& x) { return columns(x).row(2).mean(); }

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double d = meanHeight(x) - h0;
  return 0.5 * k * d * d;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  Columns F = Columns::Zero(3, x.size() / 3);
  F.row(2).setConstant(-k * (meanHeight(x) - h0) / static_cast<double>(F.cols()));
  return Eigen::Map<VecX>(F.data(), F.size());
}

double spread(const VecX& x, const VecX& m) {
  const VecX squares = fromCentre(x, m).colwise().squaredNorm().transpose();
  return std::sqrt(squares.dot(m) / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  if (R == 0.0) return VecX::Zero(x.size());
  const Columns G = fromCentre(x, m) * m.asDiagonal() / (m.sum() * R);
  return Eigen::Map<const VecX>(G.data(), G.size());
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double d = spread(x, m) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double tension = k * (spread(x, m) - R0);
  return tension * spreadGradient(x, m);
}
