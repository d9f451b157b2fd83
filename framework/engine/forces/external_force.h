#pragma once
#include "engine/forces/force_batch.h"

#include <functional>

namespace muelle::engine {

/// The same force, a function of time alone, on each of some nodes. Where it jumps is declared; each force with
/// declared times has an internal variable (segment.h).
template <int D>
class ExternalForce final : public ForceBatch, private SwitchingPiece {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  struct Item {
    std::vector<int> nodes;  ///< free ones, of the built numbering
    std::function<Vector(double t, int segment)> force;
    std::vector<double> times;  ///< ascending [s]
  };

  explicit ExternalForce(std::vector<Item> items) : items_(std::move(items)) {}

  bool isConservative() const override { return false; }
  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration&) const override { return 0.0; }
  void addConservativeForce(const Configuration&, double*) const override {}
  void addDiscreteGradientForce(const Configuration&, const Configuration&, double*) const override {}

  SwitchingPiece* switchingPiece() override { return this; }

 private:
  int internalSize() const override;
  void declaredTimes(double from, double to, std::vector<double>& times) const override;
  bool commit(const Configuration& at, bool frozen, double* z) const override;

  std::vector<Item> items_;
};

extern template class ExternalForce<1>;
extern template class ExternalForce<2>;
extern template class ExternalForce<3>;

}  // namespace muelle::engine
