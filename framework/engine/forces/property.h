#pragma once
#include "engine/forces/force_batch.h"

namespace muelle::engine {

/// Energy of a property of many nodes (slide "Fuerzas y Energias"): E = k (p - p0)^2 / 2 with p = sum_i w_i x_i over
/// coordinates, such as the mean height. F_i = -k (p - p0) w_i; the Hessian k w w^T has rank 1 and is never formed.
/// p is one sum in the order of the coordinates, so its last bit is the same in every run.
class Property final : public ForceBatch, private LowRankPiece, private ConstraintPiece {
 public:
  struct Entry {
    int lane = 0;      ///< of the coordinate
    int unknown = -1;  ///< its number among the unknowns; -1 where the node is held
    double weight = 0.0;
  };

  /// \param entries ascending, each lane once   \param userIndex for messages
  Property(std::vector<Entry> entries, double k, double p0, int userIndex);

  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration& at) const override;
  void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const override;
  LowRankPiece* lowRankPiece() override { return this; }
  ConstraintPiece* constraintPiece() override { return this; }

 private:
  int columns() const override { return 1; }
  void writeLowRank(double cK, Eigen::Ref<Eigen::MatrixXd> U, Eigen::Ref<Eigen::VectorXd> s) const override;
  /// One constraint when it has no more unknowns than a Constraint has room for, else left out.
  int constraintCount() const override { return fits() ? 1 : 0; }
  void project(const Configuration& at, const ConstraintProjection& projection) const override;
  void evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const override;
  std::string leftOut() const override;

  bool evaluate(const Configuration& at, Constraint& out) const;
  double value(const double* x) const;
  void addWeights(double factor, double* f) const;
  bool fits() const { return entries_.size() <= Constraint{}.lane.size(); }

  std::vector<Entry> entries_;
  double k_, p0_;
  int userIndex_;
};

}  // namespace muelle::engine
