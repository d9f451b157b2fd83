#include "energy_gradient.h"

// x -> d = D x -> L = |d| -> E: the gradient is D^T times the direction times dE/dL.
namespace {
using Mat36 = Eigen::Matrix<double, 3, 6>;

Mat36 differenceMatrix() {
  Mat36 D;
  D << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  return D;
}
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double stretch = std::max(x[0], x[1]) - std::min(x[0], x[1]) - L0;
  return 0.5 * k * stretch * stretch;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double stretch = (differenceMatrix() * x).norm() - L0;
  return 0.5 * k * stretch * stretch;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Vec3 d = xa - xb;
  const double L = d.norm();
  return L != 0.0 ? Vec3(d * (1.0 / L)) : Vec3(0.0, 0.0, 0.0);
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Mat36 D = differenceMatrix();
  const double dEdL = k * ((D * x).norm() - L0);
  return D.transpose() * lengthGradient(x.head<3>(), x.tail<3>()) * dEdL;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Vec6 gradient = energyGradient(x, k, L0);
  return Vec6::Zero() - gradient;
}
