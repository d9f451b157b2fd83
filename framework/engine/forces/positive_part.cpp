#include "engine/forces/positive_part.h"

#include <Eigen/Eigenvalues>

namespace muelle::engine {

void keepPositivePart(Eigen::Ref<Eigen::MatrixXd> K) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{Eigen::MatrixXd(K)};
  const Eigen::MatrixXd scaled = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal();
  K.noalias() = scaled * eigen.eigenvectors().transpose();
}

}  // namespace muelle::engine
