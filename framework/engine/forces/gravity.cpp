#include "engine/forces/gravity.h"

#include <algorithm>

namespace muelle::engine {

void Gravity::addForce(const Configuration&, double* f) const {
  for (std::size_t i = 0; i < weight_.size(); ++i) f[i] += weight_[i];
}

void Gravity::writeForce(const Configuration&, double* f, std::size_t) const {
  std::copy_n(weight_.data(), weight_.size(), f);
}

double Gravity::energy(const Configuration& at) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < weight_.size(); ++i) sum -= weight_[i] * at.x[i];
  return sum;
}

void Gravity::addDiscreteGradientForce(const Configuration& a, const Configuration&, double* f) const {
  addForce(a, f);
}

}  // namespace muelle::engine
