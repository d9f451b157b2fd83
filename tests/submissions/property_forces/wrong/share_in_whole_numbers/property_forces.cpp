// loses: MeanHeightForce, MinusTheGradient, Equivariance, SwingingClass; misconception: integer_division
// meanHeightForce divides the whole number 1 by the whole number n, which is 0 unless there is one node.
#include "property_forces.h"

double meanHeight(const VecX& x) {
  const auto n = x.size() / 3;
  const Eigen::Map<const VecX, 0, Eigen::InnerStride<3>> z(x.data() + 2, n);
  return z.sum() / static_cast<double>(n);
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const double missing = h0 - meanHeight(x);
  return k / 2 * missing * missing;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const int n = static_cast<int>(x.size() / 3);
  VecX gradient = VecX::Zero(x.size());
  for (int i = n - 1; i >= 0; --i) gradient[3 * i + 2] = 1 / n;
  const double missing = h0 - meanHeight(x);
  return k * missing * gradient;
}

namespace {

std::vector<Vec3> arms(const VecX& x, const VecX& m) {
  const Vec3 origin = x.head<3>();
  Vec3 c = Vec3::Zero();
  double M = 0;
  for (Eigen::Index i = m.size() - 1; i >= 0; --i) {
    c += m[i] * (x.segment<3>(3 * i) - origin);
    M += m[i];
  }
  c /= M;
  std::vector<Vec3> r;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Vec3 arm = x.segment<3>(3 * i) - origin - c;
    r.push_back(arm);
  }
  return r;
}

}  // namespace

double spread(const VecX& x, const VecX& m) {
  const std::vector<Vec3> r = arms(x, m);
  const double M = m.sum();
  double R2 = 0;
  for (std::size_t i = 0; i < r.size(); ++i) R2 += m[static_cast<Eigen::Index>(i)] / M * r[i].dot(r[i]);
  return std::sqrt(R2);
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  const std::vector<Vec3> r = arms(x, m);
  const double R = spread(x, m);
  const double M = m.sum();
  VecX gradient(x.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (int j = 0; j < 3; ++j) {
      const double ofSquare = 2 * m[i] / M * r[static_cast<std::size_t>(i)][j];
      gradient[3 * i + j] = R == 0 ? 0.0 : ofSquare / (2 * R);
    }
  }
  return gradient;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const double missing = R0 - spread(x, m);
  return k / 2 * missing * missing;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  const double push = k * (R0 - spread(x, m));
  VecX F = spreadGradient(x, m);
  for (Eigen::Index i = 0; i < F.size(); ++i) F[i] *= push;
  return F;
}
