#pragma once
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace muelle::lab {

/// Something of a scene's model that could be left out.
struct ModelPart {
  enum class Kind {
    Axis,       ///< a direction in which nothing moves: 3D becomes 2D, a line along x becomes 1D
    Contact,    ///< an obstacle
    Damping,    ///< of all springs
    Drag,       ///< of all nodes
    Springs,    ///< those of one list of a generator: "cloth.bend"
    Angles,     ///< bending at the nodes of an object's lines
    Dihedrals,  ///< bending between an object's triangles
    Motion,     ///< of nodes that hardly move: they are pinned
  };
  Kind kind = Kind::Springs;
  std::string name;             ///< "contact with 'ground'", "cloth.bend"
  int axis = 1;                 ///< of Kind::Axis, in 3D
  int dimension = 2;            ///< of Kind::Axis: what is left
  std::size_t obstacle = 0;     ///< of Kind::Contact: its index in the whole scene
  std::vector<int> items = {};  ///< springs, angles, dihedrals or nodes, by their index in the whole scene
  std::string table = {};       ///< of Kind::Springs, Angles and Dihedrals: the object's name in the file
};

/// The parts that a scene has and that could be left out, whatever that does to its motion. Nodes that hardly move are
/// known only from a run: see stillNodes().
std::vector<ModelPart> partsOf(const engine::Scene& scene);

/// The scene without these parts: nodes keep their numbers. The one place that knows how a part is left out.
engine::Scene without(const engine::Scene& scene, const std::vector<ModelPart>& parts);

/// Whether all that a scene has and does lies in the plane (the line along x) that is left without a direction, so that
/// nothing ever drives it out; else the first thing that does not. Forces and motions are looked at at many times.
/// \param dimension  2: without the direction `axis`; 1: along x alone
std::string leavesPlane(const engine::Scene& scene, int axis, int dimension);

}  // namespace muelle::lab
