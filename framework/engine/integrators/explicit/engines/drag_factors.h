#pragma once
#include "engine/dynamical_system.h"

#include <vector>

namespace muelle::engine {

/// The factors with which a linear drag d_i acts on lane i during h, c = h d_i / m_i (h may be negative):
/// decay = exp(-c), phi1 = (1 - decay) / c, phi2 = (1 - phi1) / c. Without drag they are 1, 1 and 1/2.
class DragFactors {
 public:
  /// Sets the factors; does nothing when h is the same as in the last call.
  void update(const DynamicalSystem& system, double h);
  void forget() { h_ = 0.0; }

  /// decay - 1, without cancellation.
  double loss(std::size_t i) const { return factors_[i].loss; }
  double decay(std::size_t i) const { return factors_[i].decay; }
  double phi1(std::size_t i) const { return factors_[i].phi1; }
  double phi2(std::size_t i) const { return factors_[i].phi2; }

 private:
  struct Factors {
    double decay, loss, phi1, phi2;
  };
  double h_ = 0.0;
  std::vector<Factors> factors_;
};

}  // namespace muelle::engine
