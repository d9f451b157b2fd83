#pragma once
#include "engine/elements/element_batch.h"
#include "engine/model/mass_spring_system.h"
#include "engine/model/model.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

namespace muelle::engine {

/// What the makers of batches share.
struct Builder {
  const Model& model;
  const Numbering& numbering;
  std::vector<std::unique_ptr<ForceBatch>> batches = {};

  int built(int user) const { return numbering.built[static_cast<std::size_t>(user)]; }
  const ModelNode& node(int built) const {
    return model.nodes[static_cast<std::size_t>(numbering.user[static_cast<std::size_t>(built)])];
  }
  bool isFreeNode(int user) const { return isFree(model.nodes[static_cast<std::size_t>(user)]); }
  int dimension() const { return static_cast<int>(numbering.axes.size()); }
  /// An array of lanes with value(node, axis) at those of free nodes, 0 at the others.
  template <class Value>
  std::vector<double> lanes(const Value& value) const {
    std::vector<double> all(static_cast<std::size_t>(numbering.layout.storage), 0.0);
    for (const int i : numbering.freeNodes) {
      for (int c = 0; c < dimension(); ++c) {
        all[static_cast<std::size_t>(numbering.layout.lane(i, c))] =
            value(node(i), numbering.axes[static_cast<std::size_t>(c)]);
      }
    }
    return all;
  }
};

/// Adds a batch of make(element, its nodes in the built numbering); elements without a free node move nothing and are
/// left out.
template <int D, class Element, class ModelElement, class Make>
void addElements(Builder& builder, const std::vector<ModelElement>& elements, const Make& make) {
  std::vector<Element> made;
  for (const ModelElement& element : elements) {
    if (!anyFree(builder.model, element.nodes)) continue;
    auto nodes = element.nodes;
    for (int& node : nodes) node = builder.built(node);
    made.push_back(make(element, nodes));
  }
  if (!made.empty()) builder.batches.push_back(std::make_unique<ElementBatch<D, Element>>(std::move(made)));
}

}  // namespace muelle::engine
