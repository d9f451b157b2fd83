#include "engine/elements/angle/angle.h"

#include "engine/elements/element_batch_impl.h"
#include "engine/elements/gonzalez.h"

#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

template <int D>
using Direction = Eigen::Matrix<double, D, 1>;
template <int D>
using Block = Eigen::Matrix<double, D, D>;

template <int D>
struct Edges {
  Direction<D> u, w;
  bool degenerate;

  explicit Edges(const Eigen::Matrix<double, D, 3>& X) : u(X.col(1) - X.col(0)), w(X.col(2) - X.col(1)) {
    degenerate = !(u.squaredNorm() > 0.0 && w.squaredNorm() > 0.0);
  }
};

double angleOf(const Edges<2>& at) { return std::atan2(at.u[0] * at.w[1] - at.u[1] * at.w[0], at.u.dot(at.w)); }

double angleOf(const Edges<3>& at) { return std::atan2(at.u.cross(at.w).norm(), at.u.dot(at.w)); }

/// Gradient and Hessian in (u, w) to those in (a, b, c).
template <int D>
Eigen::Matrix<double, 3 * D, 1> toNodes(const Direction<D>& gu, const Direction<D>& gw) {
  Eigen::Matrix<double, 3 * D, 1> g;
  g << -gu, gu - gw, gw;
  return g;
}

template <int D>
Eigen::Matrix<double, 3 * D, 3 * D> toNodes(const Block<D>& uu, const Block<D>& uw, const Block<D>& ww) {
  Eigen::Matrix<double, 3 * D, 3 * D> H;
  const Block<D> wu = uw.transpose();
  H << uu, -uu + uw, -uw,  //
      -uu + wu, uu - uw - wu + ww, uw - ww, -wu, wu - ww, ww;
  return H;
}

/// Gradient and Hessian of the polar angle of p.
Direction<2> polarGradient(const Direction<2>& p) { return Direction<2>(-p[1], p[0]) / p.squaredNorm(); }

Block<2> polarHessian(const Direction<2>& p) {
  const double r2 = p.squaredNorm();
  Block<2> H;
  H << 2.0 * p[0] * p[1], p[1] * p[1] - p[0] * p[0], p[1] * p[1] - p[0] * p[0], -2.0 * p[0] * p[1];
  return H / (r2 * r2);
}

/// Discrete gradient of the polar angle: the difference atan2(c, d), c = pa x pb = turn(mean) . (pb - pa), over c.
Direction<2> polarDiscreteGradient(const Direction<2>& pa, const Direction<2>& pb) {
  const double c = pa[0] * pb[1] - pa[1] * pb[0], d = pa.dot(pb);
  const Direction<2> mean = 0.5 * (pa + pb), turned(-mean[1], mean[0]);
  if (c == 0.0) return d > 0.0 ? Direction<2>(turned / d) : Direction<2>::Zero();
  return (std::atan2(c, d) / c) * turned;
}

/// E as a function g of q = cos theta in 3D: dg/dq and d2g/dq2. Both are finite at straight when theta0 = 0.
struct CosineEnergy {
  double first = 0.0, second = 0.0;
  bool defined = true;

  CosineEnergy(double k, double theta, double theta0) {
    const double s = std::sin(theta), c = std::cos(theta), difference = theta - theta0;
    if (theta0 == 0.0 && theta < 3e-2) {
      // Series: theta / s and (s - theta c) / s^3, to theta^6.
      const double t = theta * theta;
      first = -k * (1.0 + t * (1.0 / 6.0 + t * (7.0 / 360.0 + t * 31.0 / 15120.0)));
      second = k * (1.0 / 3.0 + t * (2.0 / 15.0 + t * (2.0 / 63.0 + t * 4.0 / 675.0)));
      return;
    }
    if (!(s > 1e-12)) {
      defined = false;
      return;
    }
    first = -k * difference / s;
    second = k * (s - difference * c) / (s * s * s);
  }
};

}  // namespace

template <int D>
double Angle<D>::energy(const Positions& X) const {
  const Edges<D> at(X);
  if (at.degenerate) return 0.0;
  const double C = angleOf(at) - theta0;
  return 0.5 * k * C * C;
}

template <>
auto Angle<2>::gradient(const Positions& X) const -> Vector {
  const Edges<2> at(X);
  if (at.degenerate) return Vector::Zero();
  return k * (angleOf(at) - theta0) * toNodes<2>(-polarGradient(at.u), polarGradient(at.w));
}

template <>
auto Angle<3>::gradient(const Positions& X) const -> Vector {
  const Edges<3> at(X);
  if (at.degenerate) return Vector::Zero();
  const CosineEnergy g(k, angleOf(at), theta0);
  if (!g.defined) return Vector::Zero();
  const double lu = at.u.norm(), lw = at.w.norm();
  // dq/du = (w^ - q u^) / |u|, as a double cross product: no cancellation near straight beyond that of u x w.
  const Eigen::Vector3d N = at.u.cross(at.w) / (lu * lw);
  return g.first * toNodes<3>(N.cross(at.u) / (lu * lu), at.w.cross(N) / (lw * lw));
}

template <>
auto Angle<2>::hessian(const Positions& X) const -> Matrix {
  const Edges<2> at(X);
  if (at.degenerate) return Matrix::Zero();
  const Vector g = toNodes<2>(-polarGradient(at.u), polarGradient(at.w));
  const Matrix H = toNodes<2>(-polarHessian(at.u), Block<2>::Zero(), polarHessian(at.w));
  return k * (g * g.transpose() + (angleOf(at) - theta0) * H);
}

template <>
auto Angle<3>::hessian(const Positions& X) const -> Matrix {
  const Edges<3> at(X);
  if (at.degenerate) return Matrix::Zero();
  const CosineEnergy energy(k, angleOf(at), theta0);
  if (!energy.defined) return Matrix::Zero();
  const double lu = at.u.norm(), lw = at.w.norm();
  const Eigen::Vector3d u = at.u / lu, w = at.w / lw, N = u.cross(w);
  const double q = u.dot(w);
  const Eigen::Vector3d qu = N.cross(u) / lu, qw = w.cross(N) / lw;
  const Block<3> I = Block<3>::Identity();
  const auto same = [&](const Eigen::Vector3d& own, const Eigen::Vector3d& other, double L) -> Block<3> {
    return -(own * other.transpose() + other * own.transpose() + q * (I - 3.0 * own * own.transpose())) / (L * L);
  };
  const Block<3> mixed = (I - w * w.transpose() - u * (u - q * w).transpose()) / (lu * lw);
  const Vector g = toNodes<3>(qu, qw);
  return energy.second * g * g.transpose() + energy.first * toNodes<3>(same(u, w, lu), mixed, same(w, u, lw));
}

template <>
auto Angle<2>::discreteGradient(const Positions& Xa, const Positions& Xb) const -> Vector {
  const Edges<2> a(Xa), b(Xb);
  if (a.degenerate || b.degenerate) return Vector::Zero();
  return k * (0.5 * (angleOf(a) + angleOf(b)) - theta0) *
         toNodes<2>(-polarDiscreteGradient(a.u, b.u), polarDiscreteGradient(a.w, b.w));
}

template <>
auto Angle<3>::discreteGradient(const Positions& Xa, const Positions& Xb) const -> Vector {
  const Positions middle = 0.5 * (Xa + Xb), difference = Xb - Xa;
  const Edges<3> a(Xa), b(Xb), m(middle);
  if (a.degenerate || b.degenerate || m.degenerate) return Vector::Zero();
  const Vector delta = Eigen::Map<const Vector>(difference.data());
  return gonzalez<Vector>(gradient(middle), delta, energy(Xb) - energy(Xa), std::min(m.u.norm(), m.w.norm()));
}

template <>
bool Angle<2>::constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const {
  const Edges<2> at(X);
  if (at.degenerate) return false;
  C = angleOf(at) - theta0;
  stiffness = k;
  dC = toNodes<2>(-polarGradient(at.u), polarGradient(at.w));
  return true;
}

template <>
bool Angle<3>::constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const {
  const Edges<3> at(X);
  if (at.degenerate) return false;
  const double theta = angleOf(at), s = std::sin(theta);
  if (!(s > 1e-12)) return false;
  C = theta - theta0;
  stiffness = k;
  const double lu = at.u.norm(), lw = at.w.norm();
  const Eigen::Vector3d N = at.u.cross(at.w) / (lu * lw);
  dC = (-1.0 / s) * toNodes<3>(N.cross(at.u) / (lu * lu), at.w.cross(N) / (lw * lw));
  return true;
}

template class ElementBatch<2, Angle<2>>;
template class ElementBatch<3, Angle<3>>;

}  // namespace muelle::engine
