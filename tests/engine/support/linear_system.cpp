#include "support/linear_system.h"

#include <utility>

namespace muelle::engine::testing {

namespace {

using Vector = Eigen::VectorXd;

Eigen::Map<const Vector> vector(In values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }
Eigen::Map<Vector> vector(Out values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

}  // namespace

LinearSystem::LinearSystem(Eigen::VectorXd mass, Eigen::MatrixXd K, Eigen::MatrixXd D)
    : mass_(std::move(mass)), K_(std::move(K)), D_(std::move(D)), drag_(D_.diagonal()) {
  undamped_ = D_.isZero(0.0);
  diagonalDamping_ = D_.isDiagonal(0.0);
}

LinearSystem::LinearSystem(double omega, double damping)
    : LinearSystem(Vector::Ones(1), Eigen::MatrixXd::Constant(1, 1, omega * omega),
                   Eigen::MatrixXd::Constant(1, 1, damping)) {}

void LinearSystem::force(double, In x, In v, In, Out f) const {
  vector(f).noalias() = -(K_ * vector(x));
  if (!undamped_) vector(f).noalias() -= D_ * vector(v);
}

double LinearSystem::energy(double, In x, In) const { return 0.5 * vector(x).dot(K_ * vector(x)); }

void LinearSystem::conservativeForce(double, In x, In, Out f) const { vector(f).noalias() = -(K_ * vector(x)); }

void LinearSystem::discreteGradientForce(double, In xa, In xb, In, Out f) const {
  vector(f) = -(K_ * (0.5 * (vector(xa) + vector(xb))));
}

void LinearSystem::assemble(double cM, double cD, double cK, double, In, In, In, Form, SystemMatrix& J) const {
  const Eigen::MatrixXd sum = cM * Eigen::MatrixXd(mass_.asDiagonal()) + cD * D_ + cK * K_;
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < size(); ++j) {
    for (int i = 0; i < size(); ++i) entries.emplace_back(i, j, sum(i, j));
  }
  J.sparse.resize(size(), size());
  J.sparse.setFromTriplets(entries.begin(), entries.end());
  J.symmetric = true;
}

void LinearSystem::accelerationWithoutDrag(double, In x, In v, In, Out a) const {
  vector(a).noalias() = -(K_ * vector(x));
  if (!diagonalDamping_) vector(a).noalias() -= D_ * vector(v);
  vector(a).array() /= mass_.array();
}

}  // namespace muelle::engine::testing
