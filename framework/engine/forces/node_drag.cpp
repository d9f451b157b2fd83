#include "engine/forces/node_drag.h"

namespace muelle::engine {

void NodeDrag::addForce(const Configuration& at, double* f) const {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) f[i] -= coefficients_[i] * at.v[i];
}

void NodeDrag::bind(const MatrixPattern& pattern) {
  diagonal_.clear();
  for (const int node : nodes_) {
    const BlockSlot slot = pattern.slot(node, node);
    for (int c = 0; c < dimension_; ++c) diagonal_.emplace_back(slot.base + c * slot.stride + c, layout_.lane(node, c));
  }
}

void NodeDrag::addDerivatives(const Configuration&, double cD, double, Form, double* values) const {
  for (const auto& [place, lane] : diagonal_) values[place] += cD * coefficients_[static_cast<std::size_t>(lane)];
}

}  // namespace muelle::engine
