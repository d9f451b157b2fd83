#pragma once
#include "harness/types.h"

#include <cstddef>

namespace muelle::engine {

/// Where the components of nodes stand in the arrays x, v, f of a built model, in lanes.
///
/// Padded: x y z 0 of node after node, so that a node of 3D is one register of four (in 1D and 2D there is no padding).
/// Planar: x of all nodes, then y, then z, for nodes on a grid whose springs have few strides.
struct Layout {
  int node = 1;       ///< lanes from a node to the next
  int component = 1;  ///< lanes from a component to the next
  int storage = 0;    ///< lanes of all

  static Layout padded(int dimension, int nodes) {
    const int width = dimension == 3 ? 4 : dimension;
    return {width, 1, width * nodes};
  }

  /// \param plane lanes between components, at least as many as there are places
  static Layout planar(int dimension, int plane) { return {1, plane, dimension * plane}; }

  bool isPlanar() const { return component != 1; }
  int lane(int i, int c) const { return i * node + c * component; }

  /// The vector of node i.
  template <int D>
  Eigen::Matrix<double, D, 1> at(const double* values, int i) const {
    return atLane<D>(values, i * node);
  }
  /// The vector of the node whose first lane it is.
  template <int D>
  Eigen::Matrix<double, D, 1> atLane(const double* values, int lane) const {
    const double* first = values + lane;
    const std::ptrdiff_t next = component;
    // Written out: the compiler unrolls no loop whose stride it does not know.
    if constexpr (D == 1) {
      return Eigen::Matrix<double, 1, 1>(first[0]);
    } else if constexpr (D == 2) {
      return {first[0], first[next]};
    } else {
      return {first[0], first[next], first[2 * next]};
    }
  }
  /// Adds to the vector of node i.
  template <int D, class Vector>
  void add(double* values, int i, const Vector& addend) const {
    addAtLane<D>(values, i * node, addend);
  }
  /// Adds to the vector of the node whose first lane it is.
  template <int D, class Vector>
  void addAtLane(double* values, int lane, const Vector& addend) const {
    double* first = values + lane;
    const std::ptrdiff_t next = component;
    first[0] += addend[0];
    if constexpr (D > 1) first[next] += addend[1];
    if constexpr (D > 2) first[2 * next] += addend[2];
  }
};

}  // namespace muelle::engine
