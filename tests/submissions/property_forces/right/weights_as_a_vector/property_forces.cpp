#include "property_forces.h"

// The mean height is a product with a vector of weights, which is its gradient, too.
namespace {

VecX heightWeights(const VecX& x) {
  VecX w = VecX::Zero(x.size());
  for (Eigen::Index i = 2; i < x.size(); i += 3) w[i] = 3.0 / static_cast<double>(x.size());
  return w;
}

/// Positions about the centre of mass, each share of the mass before its node.
struct Relative {
  std::vector<double> share;
  std::vector<Vec3> r;

  Relative(const VecX& x, const VecX& m) {
    Vec3 c = Vec3::Zero();
    for (Eigen::Index i = 0; i < m.size(); ++i) {
      share.push_back(m[i] / m.sum());
      r.emplace_back(x.segment<3>(3 * i));
      c += share.back() * r.back();
    }
    for (Vec3& each : r) each -= c;
  }

  double radius() const {
    double square = 0;
    for (std::size_t i = 0; i < r.size(); ++i) square += share[i] * r[i].dot(r[i]);
    return std::sqrt(square);
  }
};

}  // namespace

double meanHeight(const VecX& x) { return heightWeights(x).dot(x); }

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double off = meanHeight(x) - h0;
  return k / 2 * off * off;
}

VecX meanHeightForce(const VecX& x, double h0, double k) { return k * (h0 - meanHeight(x)) * heightWeights(x); }

double spread(const VecX& x, const VecX& m) { return Relative(x, m).radius(); }

VecX spreadGradient(const VecX& x, const VecX& m) {
  const Relative at(x, m);
  const double R = at.radius();
  VecX g = VecX::Zero(x.size());
  for (std::size_t i = 0; R != 0 && i < at.r.size(); ++i) {
    g.segment<3>(3 * static_cast<Eigen::Index>(i)) = at.share[i] * (at.r[i] / R);
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double off = R0 - spread(x, m);
  return k / 2 * off * off;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const VecX uphill = k * (spread(x, m) - R0) * spreadGradient(x, m);
  return -uphill;
}
