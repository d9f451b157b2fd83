// loses: SpreadGradient; misconception: masses_left_out or no_masses_at_all
// spreadGradient gives each node the same share 1/n instead of its part of the total mass.
#include "property_forces.h"

double meanHeight(const VecX& x) {
  double mean = 0.0;
  double seen = 0.0;
  for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
    seen += 1.0;
    mean += (x[3 * i + 2] - mean) / seen;
  }
  return mean;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double h = meanHeight(x);
  return 0.5 * k * (h - h0) * (h - h0);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const double nodes = static_cast<double>(x.size()) / 3.0;
  const Vec3 up(0, 0, 1);
  const double derivative = k * (meanHeight(x) - h0) / nodes;
  VecX F(x.size());
  for (Eigen::Index i = 0; i < x.size(); i += 3) F.segment<3>(i) = -derivative * up;
  return F;
}

namespace {

struct Cloud {
  double mass = 0.0;
  Vec3 centre = Vec3::Zero();
  double squares = 0.0;  // sum of m |x - centre|^2
};

Cloud cloudOf(const VecX& x, const VecX& m) {
  Cloud cloud;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Vec3 xi = x.segment<3>(3 * i);
    const Vec3 before = xi - cloud.centre;
    const double massBefore = cloud.mass;
    cloud.mass += m[i];
    cloud.centre += m[i] / cloud.mass * before;
    cloud.squares += m[i] * massBefore / cloud.mass * before.squaredNorm();
  }
  return cloud;
}

}  // namespace

double spread(const VecX& x, const VecX& m) {
  const Cloud cloud = cloudOf(x, m);
  return std::sqrt(cloud.squares / cloud.mass);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const Cloud cloud = cloudOf(x, m);
  const double R = std::sqrt(cloud.squares / cloud.mass);
  VecX gradient = VecX::Zero(x.size());
  if (R > 0) {
    for (Eigen::Index i = 0; i < m.size(); ++i) {
      const double share = 1.0 / static_cast<double>(m.size());
      gradient.segment<3>(3 * i) = share * (x.segment<3>(3 * i) - cloud.centre) / R;
    }
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double R = spread(x, m);
  return 0.5 * k * (R - R0) * (R - R0);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double derivative = k * (spread(x, m) - R0);
  const VecX gradient = spreadGradient(x, m);
  return -derivative * gradient;
}
