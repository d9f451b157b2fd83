#include "property_forces.h"

// The nodes as the columns of a matrix.
namespace {

using Columns = Eigen::Matrix3Xd;

Columns columns(const VecX& x) { return Eigen::Map<const Columns>(x.data(), 3, x.size() / 3); }
VecX flat(const Columns& c) { return Eigen::Map<const VecX>(c.data(), c.size()); }
Columns fromCentre(const VecX& x, const VecX& m) {
  const Columns nodes = columns(x);
  const Vec3 c = nodes * m / m.sum();
  return nodes.colwise() - c;
}

}  // namespace

double meanHeight(const VecX& x) { return columns(x).row(2).mean(); }

double meanHeightEnergy(const VecX& x, double h0, double k) { return k * std::pow(meanHeight(x) - h0, 2) / 2; }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  Columns F = Columns::Zero(3, x.size() / 3);
  F.row(2).setConstant(k * (h0 - meanHeight(x)) / static_cast<double>(F.cols()));
  return flat(F);
}

double spread(const VecX& x, const VecX& m) {
  const VecX squares = fromCentre(x, m).colwise().squaredNorm();
  return std::sqrt(squares.dot(m) / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  if (R > 0) return flat(fromCentre(x, m) * m.asDiagonal()) / (R * m.sum());
  return VecX::Zero(x.size());
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) { return k * std::pow(spread(x, m) - R0, 2) / 2; }

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return k * (R0 - spread(x, m)) * spreadGradient(x, m);
}
