#include "property_forces.h"

namespace {

double heightsFrom(const VecX& x, Eigen::Index i) { return i >= x.size() ? 0.0 : x[i] + heightsFrom(x, i + 3); }

double count(const VecX& x) { return static_cast<double>(x.size()) / 3.0; }

Vec3 moments(const VecX& x, const VecX& m, Eigen::Index i) {
  return i == m.size() ? Vec3(0, 0, 0) : Vec3(m[i] * x.segment<3>(3 * i) + moments(x, m, i + 1));
}

VecX centred(const VecX& x, const VecX& m) {
  return x - (moments(x, m, 0) / m.sum()).replicate(m.size(), 1);
}

VecX massOfEachComponent(const VecX& m) {
  VecX all(3 * m.size());
  for (Eigen::Index i = 0; i < all.size(); ++i) all[i] = m[i / 3];
  return all;
}

}  // namespace

double meanHeight(const VecX& x) { return heightsFrom(x, 2) / count(x); }

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const auto square = [](double a) { return a * a; };
  return 0.5 * k * square(meanHeight(x) - h0);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  return (Vec3::UnitZ() * (-k * (meanHeight(x) - h0) / count(x))).replicate(x.size() / 3, 1);
}

double spread(const VecX& x, const VecX& m) {
  const VecX r = centred(x, m);
  return std::sqrt(r.dot(massOfEachComponent(m).cwiseProduct(r)) / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  return R == 0 ? VecX(VecX::Zero(x.size())) : VecX(massOfEachComponent(m).cwiseProduct(centred(x, m)) / m.sum() / R);
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const auto square = [](double a) { return a * a; };
  return 0.5 * k * square(spread(x, m) - R0);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return (spread(x, m) - R0) * (-k) * spreadGradient(x, m);
}
