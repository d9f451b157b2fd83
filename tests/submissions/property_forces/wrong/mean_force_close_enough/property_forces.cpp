// loses: MeanHeightForce; misconception: threshold
#include "property_forces.h"

class School {
 public:
  School(const VecX& positions, const VecX& masses) : m(masses), M(masses.sum()), d(positions) {
    Vec3 c(0, 0, 0);
    for (Eigen::Index i = 0; i < m.size(); ++i) c += m[i] * d.segment<3>(3 * i);
    c /= M;
    for (Eigen::Index i = 0; i < m.size(); ++i) d.segment<3>(3 * i) -= c;
  }
  double R() const {
    double largest = 0;
    for (Eigen::Index i = 0; i < d.size(); ++i) largest = std::max(largest, std::abs(d[i]));
    if (largest == 0) return 0;
    double mean = 0;
    for (Eigen::Index i = 0; i < d.size(); ++i) mean += m[i / 3] / M * (d[i] / largest) * (d[i] / largest);
    return largest * std::sqrt(mean);
  }
  VecX gradient() const {
    VecX g = VecX::Zero(d.size());
    const double r = R();
    for (Eigen::Index i = 0; i < d.size() && r > 0; ++i) g[i] = m[i / 3] / M * (d[i] / r);
    return g;
  }

 private:
  VecX m;
  double M;
  VecX d;
};

struct Recipe {
  double k, target;
  double energy(double p) const { return k * (p - target) * (p - target) / 2; }
  VecX force(double p, const VecX& gradient) const { return -(k * (p - target)) * gradient; }
};

double meanHeight(const VecX& x) {
  double sum = 0;
  for (Eigen::Index i = x.size() - 1; i >= 2; i -= 3) sum += x[i];
  return sum / double(x.size() / 3);
}

double meanHeightEnergy(const VecX& x, double h0, double k) { return Recipe{k, h0}.energy(meanHeight(x)); }

VecX meanHeightForce(const VecX& x, double h0, double k) {
  VecX gradient = VecX::Zero(x.size());
  if (std::abs(meanHeight(x) - h0) < 1e-6) return gradient;  // there already
  for (Eigen::Index i = 2; i < x.size(); i += 3) gradient[i] = 3.0 / double(x.size());
  return Recipe{k, h0}.force(meanHeight(x), gradient);
}

double spread(const VecX& x, const VecX& m) { return School(x, m).R(); }

VecX spreadGradient(const VecX& x, const VecX& m) { return School(x, m).gradient(); }

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) { return Recipe{k, R0}.energy(spread(x, m)); }

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  return Recipe{k, R0}.force(spread(x, m), spreadGradient(x, m));
}
