#include "engine/elements/area/area.h"

#include "engine/elements/element_batch_impl.h"

namespace muelle::engine {

template <int D>
double Area<D>::area(const Positions& X) const {
  return 0.5 * (X.col(1) - X.col(0)).dot(S * (X.col(2) - X.col(0)));
}

template <int D>
auto Area<D>::areaGradient(const Positions& X) const -> Vector {
  const Eigen::Matrix<double, D, 1> du = 0.5 * S * (X.col(2) - X.col(0));
  const Eigen::Matrix<double, D, 1> dw = -0.5 * S * (X.col(1) - X.col(0));
  Vector g;
  g << -du - dw, du, dw;
  return g;
}

template <int D>
double Area<D>::energy(const Positions& X) const {
  const double C = area(X) - A0;
  return 0.5 * k * C * C;
}

template <int D>
auto Area<D>::gradient(const Positions& X) const -> Vector {
  return k * (area(X) - A0) * areaGradient(X);
}

template <int D>
auto Area<D>::hessian(const Positions& X) const -> Matrix {
  const Vector g = areaGradient(X);
  Matrix H = k * g * g.transpose();
  // The second derivative of A couples u and w by S / 2; a has minus the sum of both.
  const Turn B = (0.5 * k * (area(X) - A0)) * S;
  H.template block<D, D>(D, 2 * D) += B;
  H.template block<D, D>(2 * D, D) -= B;
  H.template block<D, D>(0, D) += B;
  H.template block<D, D>(D, 0) -= B;
  H.template block<D, D>(0, 2 * D) -= B;
  H.template block<D, D>(2 * D, 0) += B;
  return H;
}

template <int D>
auto Area<D>::discreteGradient(const Positions& Xa, const Positions& Xb) const -> Vector {
  return k * (0.5 * (area(Xa) + area(Xb)) - A0) * areaGradient(0.5 * (Xa + Xb));
}

template <int D>
bool Area<D>::constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const {
  C = area(X) - A0;
  stiffness = k;
  dC = areaGradient(X);
  return true;
}

template class ElementBatch<2, Area<2>>;
template class ElementBatch<3, Area<3>>;

}  // namespace muelle::engine
