#include "engine/elements/volume/volume.h"

#include "engine/elements/cross_matrix.h"
#include "engine/elements/element_batch_impl.h"

#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

double volume(const Volume::Positions& X) {
  const Vec3 u = X.col(1) - X.col(0), w = X.col(2) - X.col(0), y = X.col(3) - X.col(0);
  return u.dot(w.cross(y)) / 6.0;
}

Volume::Vector volumeGradient(const Volume::Positions& X) {
  const Vec3 u = X.col(1) - X.col(0), w = X.col(2) - X.col(0), y = X.col(3) - X.col(0);
  const Vec3 du = w.cross(y) / 6.0, dw = y.cross(u) / 6.0, dy = u.cross(w) / 6.0;
  Volume::Vector g;
  g << -du - dw - dy, du, dw, dy;
  return g;
}

}  // namespace

double Volume::energy(const Positions& X) const {
  const double C = volume(X) - V0;
  return 0.5 * k * C * C;
}

auto Volume::gradient(const Positions& X) const -> Vector { return k * (volume(X) - V0) * volumeGradient(X); }

auto Volume::hessian(const Positions& X) const -> Matrix {
  const Vec3 u = X.col(1) - X.col(0), w = X.col(2) - X.col(0), y = X.col(3) - X.col(0);
  // dV/du = w x y / 6 and so on round: the blocks between different edges are cross-product matrices.
  const double factor = k * (volume(X) - V0) / 6.0;
  Eigen::Matrix<double, 9, 9> edges = Eigen::Matrix<double, 9, 9>::Zero();
  const auto set = [&](int row, int column, const Vec3& r) {
    edges.block<3, 3>(3 * row, 3 * column) = factor * crossMatrix(r);
    edges.block<3, 3>(3 * column, 3 * row) = -factor * crossMatrix(r);
  };
  set(0, 1, -y);
  set(0, 2, w);
  set(1, 2, -u);
  const Vector g = volumeGradient(X);
  return k * g * g.transpose() + fromEdges<3>(edges);
}

auto Volume::discreteGradient(const Positions& Xa, const Positions& Xb) const -> Vector {
  const Vector mean = (volumeGradient(Xa) + 4.0 * volumeGradient(0.5 * (Xa + Xb)) + volumeGradient(Xb)) / 6.0;
  return k * (0.5 * (volume(Xa) + volume(Xb)) - V0) * mean;
}

bool Volume::constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const {
  C = volume(X) - V0;
  stiffness = k;
  dC = volumeGradient(X);
  return true;
}

template class ElementBatch<3, Volume>;

}  // namespace muelle::engine
