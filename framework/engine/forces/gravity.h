#pragma once
#include "engine/forces/force_batch.h"

namespace muelle::engine {

/// Weight m g on every unknown (slide "Todo junto"): E = -m g . x, whose Hessian is zero.
class Gravity final : public ForceBatch {
 public:
  /// \param weight [N] of each lane, m g along its axis; 0 where it is no unknown
  explicit Gravity(std::vector<double> weight) : weight_(std::move(weight)) {}

  bool isUniformField() const override { return true; }
  void addForce(const Configuration& at, double* f) const override;
  void writeForce(const Configuration& at, double* f, std::size_t lanes) const override;
  double energy(const Configuration& at) const override;
  void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const override;

 private:
  std::vector<double> weight_;
};

}  // namespace muelle::engine
