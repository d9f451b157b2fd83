#include "energy_gradient.h"

using Difference = Eigen::Matrix<double, 3, 6>;

// D x = xa - xb
static Difference differenceMatrix() {
  Difference D;
  D << muelle::Mat3::Identity(), -muelle::Mat3::Identity();
  return D;
}

double springEnergy1d(const Vec2& x, double k, double L0) {
  Vec6 inSpace = Vec6::Zero();
  inSpace[0] = x[0];
  inSpace[3] = x[1];
  return springEnergy(inSpace, k, L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 r = differenceMatrix() * x;
  const double root = std::sqrt(0.5 * k) * (r.stableNorm() - L0);
  return root * root;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  if (xa == xb) return Vec3::Zero();
  return (xa - xb).stableNormalized();
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Difference D = differenceMatrix();
  const Vec3 r = D * x;
  return D.transpose() * (k * (r.stableNorm() - L0) * lengthGradient(r, Vec3::Zero()));
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  // The force on a node is the gradient with respect to the other one.
  const Vec6 gradient = energyGradient(x, k, L0);
  Vec6 F;
  F << gradient.tail<3>(), gradient.head<3>();
  return F;
}
