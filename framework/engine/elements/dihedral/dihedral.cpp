#include "engine/elements/dihedral/dihedral.h"

#include "engine/elements/cross_matrix.h"
#include "engine/elements/element_batch_impl.h"
#include "engine/elements/gonzalez.h"

#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

struct Edges {
  Vec3 e, p, q, Np, Nq;  ///< Np = e x p, Nq = e x q
  bool degenerate;

  explicit Edges(const Dihedral::Positions& X)
      : e(X.col(1) - X.col(0)), p(X.col(2) - X.col(0)), q(X.col(3) - X.col(0)), Np(e.cross(p)), Nq(e.cross(q)) {
    degenerate = !(e.squaredNorm() > 0.0 && Np.squaredNorm() > 0.0 && Nq.squaredNorm() > 0.0);
  }
  /// From Np to -Nq, about e.
  double angle() const { return std::atan2(-Np.cross(Nq).dot(e) / e.norm(), -Np.dot(Nq)); }
};

/// A(r) and what it brings along e, with derivatives.
struct Turning {
  Vec3 A;
  double s;  ///< r . e / e^2
  Mat3 dAdr, dAde;
  Vec3 dsdr, dsde;

  Turning(const Vec3& e, const Vec3& r, const Vec3& N) {
    const double length = e.norm(), square = N.squaredNorm(), e2 = e.squaredNorm();
    A = (length / square) * N;
    s = r.dot(e) / e2;
    const Mat3 mirror = (length / square) * (Mat3::Identity() - (2.0 / square) * N * N.transpose());
    dAdr = mirror * crossMatrix(e);
    dAde = N * e.transpose() / (length * square) - mirror * crossMatrix(r);
    dsdr = e / e2;
    dsde = r / e2 - (2.0 * s / e2) * e;
  }
};

Dihedral::Vector angleGradient(const Edges& at) {
  const double length = at.e.norm(), e2 = at.e.squaredNorm();
  const Vec3 gp = -(length / at.Np.squaredNorm()) * at.Np, gq = (length / at.Nq.squaredNorm()) * at.Nq;
  const Vec3 ge = -(at.p.dot(at.e) / e2) * gp - (at.q.dot(at.e) / e2) * gq;
  Dihedral::Vector g;
  g << -ge - gp - gq, ge, gp, gq;
  return g;
}

Dihedral::Matrix angleHessian(const Edges& at) {
  const Turning p(at.e, at.p, at.Np), q(at.e, at.q, at.Nq);
  Eigen::Matrix<double, 9, 9> H = Eigen::Matrix<double, 9, 9>::Zero();
  H.block<3, 3>(3, 3) = -p.dAdr;
  H.block<3, 3>(3, 0) = -p.dAde;
  H.block<3, 3>(6, 6) = q.dAdr;
  H.block<3, 3>(6, 0) = q.dAde;
  H.block<3, 3>(0, 3) = H.block<3, 3>(3, 0).transpose();
  H.block<3, 3>(0, 6) = H.block<3, 3>(6, 0).transpose();
  const Mat3 ee = p.A * p.dsde.transpose() + p.s * p.dAde - q.A * q.dsde.transpose() - q.s * q.dAde;
  H.block<3, 3>(0, 0) = 0.5 * (ee + ee.transpose());
  return fromEdges<3>(H);
}

}  // namespace

double Dihedral::energy(const Positions& X) const {
  const Edges at(X);
  if (at.degenerate) return 0.0;
  const double C = at.angle() - theta0;
  return 0.5 * k * C * C;
}

auto Dihedral::gradient(const Positions& X) const -> Vector {
  const Edges at(X);
  if (at.degenerate) return Vector::Zero();
  return k * (at.angle() - theta0) * angleGradient(at);
}

auto Dihedral::hessian(const Positions& X) const -> Matrix {
  const Edges at(X);
  if (at.degenerate) return Matrix::Zero();
  const Vector g = angleGradient(at);
  return k * (g * g.transpose() + (at.angle() - theta0) * angleHessian(at));
}

auto Dihedral::discreteGradient(const Positions& Xa, const Positions& Xb) const -> Vector {
  const Positions middle = 0.5 * (Xa + Xb), difference = Xb - Xa;
  const Edges a(Xa), b(Xb), m(middle);
  if (a.degenerate || b.degenerate || m.degenerate) return Vector::Zero();
  const double thetaA = a.angle(), thetaB = b.angle();
  const double height = std::min(m.Np.norm(), m.Nq.norm()) / m.e.norm();
  const Vector delta = Eigen::Map<const Vector>(difference.data());
  return k * (0.5 * (thetaA + thetaB) - theta0) * gonzalez<Vector>(angleGradient(m), delta, thetaB - thetaA, height);
}

bool Dihedral::constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const {
  const Edges at(X);
  if (at.degenerate) return false;
  C = at.angle() - theta0;
  stiffness = k;
  dC = angleGradient(at);
  return true;
}

template class ElementBatch<3, Dihedral>;

}  // namespace muelle::engine
