// loses: MeanHeightEnergy, MinusTheGradient; misconception: missing_stiffness
#include "property_forces.h"

namespace {

int nodeCount(const VecX& x) { return static_cast<int>(x.size()) / 3; }

Vec3 node(const VecX& x, int i) { return x.segment<3>(3 * i); }

Vec3 centre(const VecX& x, const VecX& m) {
  Vec3 c = Vec3::Zero();
  for (int i = 0; i < nodeCount(x); ++i) c += m[i] * node(x, i);
  return c / m.sum();
}

}  // namespace

double meanHeight(const VecX& x) {
  double h = 0;
  for (int i = 0; i < nodeCount(x); ++i) h += x[3 * i + 2];
  return h / nodeCount(x);
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  static_cast<void>(k);
  const double d = meanHeight(x) - h0;
  return 0.5 * d * d;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = nodeCount(x);
  const double f = -k * (meanHeight(x) - h0) / n;
  VecX F = VecX::Zero(x.size());
  for (int i = 0; i < n; ++i) F[3 * i + 2] = f;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const Vec3 c = centre(x, m);
  double sum = 0;
  for (int i = 0; i < nodeCount(x); ++i) sum += m[i] * (node(x, i) - c).squaredNorm();
  return std::sqrt(sum / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (R == 0) return g;
  const Vec3 c = centre(x, m);
  for (int i = 0; i < nodeCount(x); ++i) g.segment<3>(3 * i) = m[i] / (m.sum() * R) * (node(x, i) - c);
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double d = spread(x, m) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return -k * (spread(x, m) - R0) * spreadGradient(x, m);
}
