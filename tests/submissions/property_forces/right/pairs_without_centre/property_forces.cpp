#include "property_forces.h"

// The centre of mass is not needed: sum_i m_i |x_i - c|^2 is the sum over all pairs of m_i m_j |x_i - x_j|^2, over M.

namespace {

class Parabola {  // 1/2 k (p - target)^2
 public:
  Parabola(double target, double k) : target_(target), k_(k) {}
  double at(double p) const { return k_ * (p - target_) * (p - target_) / 2; }
  double slopeAt(double p) const { return k_ * (p - target_); }

 private:
  double target_, k_;
};

Vec3 place(const VecX& x, Eigen::Index node) { return {x[3 * node], x[3 * node + 1], x[3 * node + 2]}; }

}  // namespace

double meanHeight(const VecX& x) {
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> nodes(x.data(), 3, x.size() / 3);
  return nodes.row(2).mean();
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return Parabola(h0, k).at(meanHeight(x)); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const Eigen::Index n = x.size() / 3;
  const Vec3 each(0, 0, -Parabola(h0, k).slopeAt(meanHeight(x)) / static_cast<double>(n));
  return each.replicate(n, 1);
}

double spread(const VecX& x, const VecX& m) {
  double pairs = 0.0;
  for (Eigen::Index i = 1; i < m.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) pairs += m[i] * m[j] * (place(x, i) - place(x, j)).squaredNorm();
  }
  return std::sqrt(pairs) / m.sum();
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const double R = spread(x, m), M = m.sum();
  VecX gradient = VecX::Zero(x.size());
  if (R == 0) return gradient;
  for (Eigen::Index i = 1; i < m.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const Vec3 apart = (m[i] / M) * (m[j] / M) * ((place(x, i) - place(x, j)) / R);
      gradient.segment<3>(3 * i) += apart;
      gradient.segment<3>(3 * j) -= apart;
    }
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) { return Parabola(R0, k).at(spread(x, m)); }

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  VecX F = spreadGradient(x, m);
  const double slope = Parabola(R0, k).slopeAt(spread(x, m));
  for (double& component : F) component *= -slope;
  return F;
}
