// loses: MeanHeightForce, MinusTheGradient, Equivariance, SwingingClass; misconception: integer_division
// right for one pupil
#include "property_forces.h"

#include <numeric>

namespace {

std::vector<Vec3> pupils(const VecX& x) {
  std::vector<Vec3> all;
  for (Eigen::Index i = 0; i + 2 < x.size(); i += 3) all.emplace_back(x[i], x[i + 1], x[i + 2]);
  return all;
}

double totalMass(const VecX& m) { return std::accumulate(m.begin(), m.end(), 0.0); }

Vec3 centreOf(const std::vector<Vec3>& all, const VecX& m) {
  Vec3 sum(0, 0, 0);
  Eigen::Index i = 0;
  for (const Vec3& p : all) sum += m[i++] * p;
  return sum / totalMass(m);
}

}  // namespace

double meanHeight(const VecX& x) {
  const auto all = pupils(x);
  const double sum = std::accumulate(all.begin(), all.end(), 0.0, [](double s, const Vec3& p) { return s + p.z(); });
  return sum / static_cast<double>(all.size());
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  const auto square = [](double d) { return d * d; };
  return 0.5 * k * square(meanHeight(x) - h0);
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  const Eigen::Index n = x.size() / 3;
  const Vec3 onEach(0, 0, -k * (meanHeight(x) - h0) * (1 / n));
  return onEach.replicate(n, 1);
}

double spread(const VecX& x, const VecX& m) {
  const auto all = pupils(x);
  const Vec3 c = centreOf(all, m);
  Eigen::Index i = 0;
  const double sum = std::accumulate(all.begin(), all.end(), 0.0,
                                     [&](double s, const Vec3& p) { return s + m[i++] * (p - c).squaredNorm(); });
  return std::sqrt(sum / totalMass(m));
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  VecX g = VecX::Zero(x.size());
  const double R = spread(x, m);
  if (!(R > 0)) return g;
  const auto all = pupils(x);
  const Vec3 c = centreOf(all, m);
  Eigen::Index i = 0;
  for (const Vec3& p : all) {
    g.segment<3>(3 * i) = m[i] * (p - c) / (totalMass(m) * R);
    ++i;
  }
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  const auto square = [](double d) { return d * d; };
  return 0.5 * k * square(spread(x, m) - R0);
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  VecX F = spreadGradient(x, m);
  F *= -k * (spread(x, m) - R0);
  return F;
}
