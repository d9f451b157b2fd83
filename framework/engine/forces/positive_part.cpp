#include "engine/forces/positive_part.h"

#include "engine/solve/dense.h"

namespace muelle::engine {

void keepPositivePart(Eigen::Ref<Eigen::MatrixXd> K) {
  const SymmetricEigenpairs eigen = symmetricEigenpairs(K);
  const Eigen::MatrixXd scaled = eigen.vectors * eigen.values.cwiseMax(0.0).asDiagonal();
  K.noalias() = scaled * eigen.vectors.transpose();
}

}  // namespace muelle::engine
