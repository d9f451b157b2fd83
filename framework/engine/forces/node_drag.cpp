#include "engine/forces/node_drag.h"

namespace muelle::engine {

void NodeDrag::addForce(const Configuration& at, double* f) const {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) f[i] -= coefficients_[i] * at.v[i];
}

void NodeDrag::bind(const MatrixPattern& pattern) {
  diagonal_.resize(coefficients_.size());
  for (int i = 0; i < static_cast<int>(coefficients_.size()); ++i) {
    const BlockSlot slot = pattern.slot(i / dimension_, i / dimension_);
    const int axis = i % dimension_;
    diagonal_[static_cast<std::size_t>(i)] = slot.base + axis * slot.stride + axis;
  }
}

void NodeDrag::addDerivatives(const Configuration&, double cD, double, Form, double* values) const {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) values[diagonal_[i]] += cD * coefficients_[i];
}

}  // namespace muelle::engine
