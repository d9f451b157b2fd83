// loses: Forces, StretchAndRelease; misconception: halved or half_kept
// the two nodes share the force
#include "energy_gradient.h"

// The difference of the two nodes is linear: xa - xb = B x with B = (I, -I). So the gradient is B^T times one of R^3.
using Mat36 = Eigen::Matrix<double, 3, 6>;

static Mat36 differenceMatrix() {
  Mat36 B;
  B.leftCols<3>().setIdentity();
  B.rightCols<3>() = -Eigen::Matrix3d::Identity();
  return B;
}

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double L = std::fabs(Vec2(1.0, -1.0).dot(x));
  return 0.5 * k * (L - L0) * (L - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  const Vec3 r = differenceMatrix() * x;
  const double L = r.stableNorm();
  return 0.5 * k * (L - L0) * (L - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec3 r = xa - xb;
  const double L = r.stableNorm();
  if (L > 0.0) r = r / L;
  return r;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Mat36 B = differenceMatrix();
  const Vec3 r = B * x;
  const Vec3 n = lengthGradient(r, Vec3::Zero());
  return B.transpose() * (k * (r.stableNorm() - L0) * n);
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Mat36 B = differenceMatrix();
  const Vec3 r = B * x;
  const Vec3 n = lengthGradient(r, Vec3::Zero());
  return B.transpose() * (0.5 * k * (L0 - r.stableNorm()) * n);
}
