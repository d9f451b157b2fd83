#include "property_forces.h"

// One recipe for both properties.
namespace {

double energyOf(double p, double p0, double k) { return 0.5 * k * (p - p0) * (p - p0); }

template <class Gradient>
VecX forceOf(double p, double p0, double k, const Gradient& gradient) {
  return -(k * (p - p0)) * gradient;
}

VecX meanHeightGradient(const VecX& x) {
  const int n = static_cast<int>(x.size() / 3);
  VecX g = VecX::Zero(3 * n);
  for (int i = 0; i < n; ++i) g.segment<3>(3 * i) = Vec3(0, 0, 1) / n;
  return g;
}

}  // namespace

double meanHeight(const VecX& x) {
  const int n = static_cast<int>(x.size() / 3);
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < n; ++i) mean += x.segment<3>(3 * i) / n;
  return mean[2];
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return energyOf(meanHeight(x), h0, k); }
VecX meanHeightForce(const VecX& x, double h0, double k) { return forceOf(meanHeight(x), h0, k, meanHeightGradient(x)); }

double spread(const VecX& x, const VecX& m) {
  double M = 0;
  Vec3 moment = Vec3::Zero();
  for (int i = 0; i < m.size(); ++i) {
    M += m[i];
    moment += m[i] * x.segment<3>(3 * i);
  }
  double R2 = 0;
  for (int i = 0; i < m.size(); ++i) {
    const Vec3 r = x.segment<3>(3 * i) - moment / M;
    R2 += m[i] / M * (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  }
  return std::sqrt(R2);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  Vec3 moment = Vec3::Zero();
  for (int i = 0; i < m.size(); ++i) moment += m[i] * x.segment<3>(3 * i);
  VecX half = VecX::Zero(x.size());  // of the gradient of R^2
  for (int i = 0; i < m.size(); ++i) half.segment<3>(3 * i) = m[i] * (x.segment<3>(3 * i) - moment / m.sum()) / m.sum();
  return R == 0.0 ? VecX(VecX::Zero(x.size())) : VecX(half / R);
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) { return energyOf(spread(x, m), R0, k); }
VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return forceOf(spread(x, m), R0, k, spreadGradient(x, m));
}
