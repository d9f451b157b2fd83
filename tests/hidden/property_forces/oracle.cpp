/// \file
/// The expected values, another way: heights are a row of the 3 x n matrix of positions, and the spread is a sum over
/// pairs, M^2 R^2 = sum over i < j of mi mj |xi - xj|^2, which knows no centre of mass.

#include "property_forces.h"

namespace {

using Columns = Eigen::Map<const Eigen::Matrix3Xd>;

Columns columns(const VecX& x) { return {x.data(), 3, x.size() / 3}; }

/// Of nodes that have both a place and a mass: mistakes are looked for with x and m exchanged, too.
Eigen::Index countOf(const VecX& x, const VecX& m) { return std::min(x.size() / 3, m.size()); }

}  // namespace

namespace oracle {

double meanHeight(const VecX& x) { return columns(x).row(2).mean(); }

double meanHeightEnergy(const VecX& x, double h0, double k) { return k / 2 * std::pow(given::meanHeight(x) - h0, 2); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  Eigen::Matrix3Xd F = Eigen::Matrix3Xd::Zero(3, x.size() / 3);
  F.row(2).setConstant(k * (h0 - given::meanHeight(x)) / static_cast<double>(F.cols()));
  return Eigen::Map<const VecX>(F.data(), F.size());
}

double spread(const VecX& x, const VecX& m) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < countOf(x, m); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) sum += m[i] * m[j] * (columns(x).col(i) - columns(x).col(j)).squaredNorm();
  }
  return std::sqrt(sum) / m.sum();
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX gradient = VecX::Zero(x.size());
  const double R = given::spread(x, m);
  if (R == 0) return gradient;
  for (Eigen::Index i = 0; i < countOf(x, m); ++i) {
    for (Eigen::Index j = 0; j < countOf(x, m); ++j) {
      gradient.segment<3>(3 * i) += m[j] / m.sum() * (columns(x).col(i) - columns(x).col(j));
    }
    gradient.segment<3>(3 * i) *= m[i] / m.sum() / R;
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return k / 2 * std::pow(given::spread(x, m) - R0, 2);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return k * (R0 - given::spread(x, m)) * given::spreadGradient(x, m);
}

}  // namespace oracle
