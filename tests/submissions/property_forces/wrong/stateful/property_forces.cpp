// loses: all; misconception: stateful
#include "property_forces.h"

#include <utility>

// Right, one call late.

namespace {

int nodeCount(const VecX& x) { return static_cast<int>(x.size()) / 3; }

Vec3 centre(const VecX& x, const VecX& m) {
  Vec3 c = Vec3::Zero();
  for (int i = 0; i < nodeCount(x); ++i) c += m[i] * x.segment<3>(3 * i);
  return c / m.sum();
}

}  // namespace

namespace {

double height(const VecX& x) {
  double h = 0;
  for (int i = 0; i < nodeCount(x); ++i) h += x[3 * i + 2];
  return h / nodeCount(x);
}

double radius(const VecX& x, const VecX& m) {
  double sum = 0;
  for (int i = 0; i < nodeCount(x); ++i) sum += m[i] * (x.segment<3>(3 * i) - centre(x, m)).squaredNorm();
  return std::sqrt(sum / m.sum());
}

VecX gradient(const VecX& x, const VecX& m) {
  const double R = radius(x, m);
  VecX g = VecX::Zero(x.size());
  for (int i = 0; i < nodeCount(x) && R > 0; ++i) {
    g.segment<3>(3 * i) = m[i] / (m.sum() * R) * (x.segment<3>(3 * i) - centre(x, m));
  }
  return g;
}

}  // namespace

double meanHeight(const VecX& x) {
  static double previous = 0;
  return std::exchange(previous, height(x));
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  static double previous = 0;
  return std::exchange(previous, 0.5 * k * std::pow(height(x) - h0, 2));
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  static double previous = 0;
  const double now = -k * (height(x) - h0) / nodeCount(x);
  VecX F = VecX::Zero(x.size());
  for (int i = 0; i < nodeCount(x); ++i) F[3 * i + 2] = previous;
  previous = now;
  return F;
}

double spread(const VecX& x, const VecX& m) {
  static double previous = 0;
  return std::exchange(previous, radius(x, m));
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  static VecX previous;
  VecX g = gradient(x, m);
  if (previous.size() != x.size()) previous = VecX::Zero(x.size());
  previous.swap(g);
  return g;
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  static double previous = 0;
  return std::exchange(previous, 0.5 * k * std::pow(radius(x, m) - R0, 2));
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  static double previous = 0;
  return std::exchange(previous, -k * (radius(x, m) - R0)) * gradient(x, m);
}
