// loses: SpreadGradient; misconception: centre_counted_twice
#include "property_forces.h"

// w = m / M, one weight a node; they add up to 1

static VecX weights(const VecX& m) { return m / m.sum(); }

static VecX fromCentre(const VecX& x, const VecX& w) {
  Vec3 c = Vec3::Zero();
  for (int i = 0; i < w.size(); ++i) c += w[i] * x.segment(3 * i, 3);
  return x - c.replicate(w.size(), 1);
}

double meanHeight(const VecX& x) {
  const Eigen::Map<const VecX, 0, Eigen::InnerStride<3>> z(x.data() + 2, x.size() / 3);
  return z.sum() / z.size();
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double d = meanHeight(x) - h0;
  return 0.5 * k * (d * d);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX F = VecX::Zero(x.size());
  Eigen::Map<VecX, 0, Eigen::InnerStride<3>> z(F.data() + 2, F.size() / 3);
  z.setConstant(-k * (meanHeight(x) - h0) / z.size());
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const VecX w = weights(m), d = fromCentre(x, w);
  double mean = 0.0;
  for (int i = 0; i < w.size(); ++i) mean += w[i] * d.segment(3 * i, 3).squaredNorm();
  return std::sqrt(mean);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m);
  if (R == 0) return VecX::Zero(x.size());
  const VecX w = weights(m);
  VecX g = fromCentre(x, w) / R;
  for (int i = 0; i < w.size(); ++i) g.segment(3 * i, 3) *= w[i] * (1 - w[i]);
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double d = spread(x, m) - R0;
  return 0.5 * k * (d * d);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return spreadGradient(x, m) * (-k * (spread(x, m) - R0));
}
