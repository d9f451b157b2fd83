#pragma once
#include "engine/forces/force_batch.h"

namespace muelle::engine {

/// Damping at the nodes, F = -d v (slide "Amortiguamiento", first of three): slows all motion, falls included.
class NodeDrag final : public ForceBatch, private StiffnessPiece {
 public:
  /// \param coefficients d [kg/s] of each lane, 0 where it is no unknown
  /// \param nodes built numbers of the free ones   \param dimension unknowns a node
  NodeDrag(std::vector<double> coefficients, std::vector<int> nodes, int dimension)
      : coefficients_(std::move(coefficients)), nodes_(std::move(nodes)), dimension_(dimension) {}

  std::span<const double> coefficients() const { return coefficients_; }

  bool isConservative() const override { return false; }
  bool usesVelocity() const override { return true; }
  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration&) const override { return 0.0; }
  void addConservativeForce(const Configuration&, double*) const override {}
  void addDiscreteGradientForce(const Configuration&, const Configuration&, double*) const override {}
  StiffnessPiece* stiffnessPiece() override { return this; }

 private:
  void bind(const MatrixPattern& pattern) override;
  void addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const override;

  std::vector<double> coefficients_;
  std::vector<int> nodes_;
  int dimension_;
  std::vector<std::pair<int, int>> diagonal_;  ///< place among the matrix's values, lane
};

}  // namespace muelle::engine
