#pragma once
#include "engine/model/model.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// The elements of a model that have one name: what can be left out of it, and what its work is counted by.
struct ModelPart {
  std::string name;
  /// How many are gone through at each force evaluation: springs, angles and the like that have a free end; of a
  /// property its nodes, of all else the free nodes that it acts on. A rod has no force, and counts 0.
  long long elements = 0;
};

/// The parts of a model, each name once, in the order of springs, angles, dihedrals, areas, volumes, properties,
/// external forces, obstacles, gravity, drag. Elements without a part of their own are "spring", "angle", "dihedral",
/// "area", "volume", "property" or "force"; the others are "obstacle NAME", "gravity", "drag" (of the nodes).
/// \param model one that validate() accepts
std::vector<ModelPart> partsOf(const Model& model);

/// The model without the parts of these names. Nodes and their numbers stay; springs and the other elements that are
/// left are counted anew. Throws std::invalid_argument as validate() does, and for a name that no part has: "there is
/// no part 'cloth.bnd'; did you mean 'cloth.bend'?"
Model withoutParts(const Model& model, const std::vector<std::string>& names);

/// The index of the name among the model's parts, where it is added when it is new.
int partNamed(Model& model, const std::string& name);

}  // namespace muelle::engine
