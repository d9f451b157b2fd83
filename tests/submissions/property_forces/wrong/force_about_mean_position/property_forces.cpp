// loses: SpreadForce, MinusTheGradient, NoNetForce; misconception: middle_for_centre
// spreadForce measures from the mean position, where all nodes count the same, and not from the centre of mass.
#include "property_forces.h"

static Vec3 centreOfMass(const VecX& x, const VecX& m) {
  Vec3 c = Vec3::Zero();
  for (Eigen::Index i = 0; i < m.size(); ++i) c += m[i] * x.segment<3>(3 * i);
  return c / m.sum();
}

double meanHeight(const VecX& x) {
  const int n = static_cast<int>(x.size()) / 3;
  double h = 0;
  for (int i = 0; i < n; i++) {
    h += x[3 * i + 2];
  }
  return h / n;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double d = meanHeight(x) - h0;
  return 0.5 * k * d * d;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = static_cast<int>(x.size()) / 3;
  const double each = -k * (meanHeight(x) - h0) * (1.0 / n);
  VecX F = VecX::Zero(x.size());
  for (int i = 0; i < n; i++) F[3 * i + 2] = each;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  const Vec3 c = centreOfMass(x, m);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < m.size(); ++i) sum += m[i] * (x.segment<3>(3 * i) - c).squaredNorm();
  return std::sqrt(sum / m.sum());
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m), M = m.sum();
  const Vec3 c = centreOfMass(x, m);
  VecX g = VecX::Zero(x.size());
  if (R > 0) {
    for (int i = 0; i < m.size(); i++) {
      const Vec3 outwards = (x.segment<3>(3 * i) - c) / R;
      g.segment<3>(3 * i) = (m[i] / M) * outwards;
    }
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double d = spread(x, m) - R0;
  return 0.5 * k * d * d;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  VecX F = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (R == 0) return F;
  const Eigen::Index n = m.size();
  Vec3 centre = Vec3::Zero();
  for (Eigen::Index i = 0; i < n; ++i) centre += x.segment<3>(3 * i);
  centre /= static_cast<double>(n);
  const double M = m.sum();
  for (Eigen::Index i = 0; i < n; ++i) {
    F.segment<3>(3 * i) = -k * (R - R0) * m[i] * (x.segment<3>(3 * i) - centre) / (M * R);
  }
  return F;
}
