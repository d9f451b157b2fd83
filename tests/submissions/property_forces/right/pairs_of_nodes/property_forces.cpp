#include "property_forces.h"

// No centre: the spread as a sum over pairs, M^2 R^2 = sum of mi mj |xi - xj|^2.
namespace {

Vec3 at(const VecX& x, Eigen::Index i) { return x.segment<3>(3 * i); }

}  // namespace

double meanHeight(const VecX& x) {
  double top = 0;
  Eigen::Index i = x.size() - 1;
  for (; i > 0; i -= 3) top += x[i];
  return 3 * top / static_cast<double>(x.size());
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return 0.5 * (meanHeight(x) - h0) * (meanHeight(x) - h0) * k; }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    F[i] = i % 3 == 2 ? -k * (meanHeight(x) - h0) * 3 / static_cast<double>(x.size()) : 0.0;
  }
  return F;
}

double spread(const VecX& x, const VecX& m) {
  double sum = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (Eigen::Index j = i + 1; j < m.size(); ++j) sum += m[i] * m[j] * (at(x, i) - at(x, j)).squaredNorm();
  }
  return std::sqrt(sum) / m.sum();
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (!(R > 0)) return g;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (Eigen::Index j = 0; j < m.size(); ++j) {
      g.segment<3>(3 * i) += m[i] * m[j] / (m.sum() * m.sum()) * (at(x, i) - at(x, j)) / R;
    }
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  return 0.5 * (spread(x, m) - R0) * (spread(x, m) - R0) * k;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return spreadGradient(x, m) * (k * R0 - k * spread(x, m));
}
