#pragma once
/// \file
/// Elements: forces between a few nodes whose energy is a function of the positions of these. Each kind is a folder
/// here, named as the kind is, with
///
///   angle.h, angle.cpp     its energy and derivatives, of nodes in the built numbering: what ElementBatch asks for
///   model_angle.h, .cpp    its plain data in a Model, and what the model asks of them:
///     static constexpr const char* kind;     its name, and that of its tables in a scene
///     static constexpr int leastDimension;   of the scenes that may have it
///     static constexpr const char* rest;     what the element wants to have, for messages: "rest angle"
///     static constexpr std::array ownKeys;   in its tables, beside nodes, k and part
///     std::array<int, N> nodes;  double k;  int part;
///     double restValue() const;
///     void check(item) const;                refuses what only this kind can have wrong; item: "angle 0"
///     static void addTo(builder, elements);  adds the batch of those that have a free node
///     std::optional<ElementSingularity> singularity(dimension, places) const;
///     void readOwn(table, model);            the own keys; nodes, k and part have been read
///   angle_table.cpp        readOwn()
///
/// and its row in forEachElementKind() of model.h. Whatever is asked of all kinds is asked through that row.

#include "harness/types.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace muelle::engine {

/// The part of an element that names none: all such of its kind are one ("spring", "angle"; see partsOf()).
inline constexpr int partOfItsKind = -1;

/// Why the energy has no gradient where nodes lie: see SingularPoint.
enum class Singularity {
  Coincident,   ///< the ends of a spring of positive rest length
  Straight,     ///< an angle in 3D that wants to be bent: it has no side to bend to
  Folded,       ///< an angle or a dihedral that is folded back onto itself
  WithoutSize,  ///< an edge of an angle without length, a triangle of a dihedral without area
  BallCentre,   ///< of an obstacle that has a node there
};

/// Below this part of the lengths around it a distance counts as none.
inline constexpr double singularCloseness = 1e-9;

/// That of one element; `what` follows its name: "at node 1 is folded back onto itself: it has no side to open to".
struct ElementSingularity {
  Singularity kind = Singularity::Straight;
  std::string what;
};

struct Builder;
struct Model;
class TableReader;

}  // namespace muelle::engine
