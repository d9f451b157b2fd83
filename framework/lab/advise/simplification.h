#pragma once
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace muelle::lab {

/// Something that a scene may do without.
struct Simplification {
  enum class Kind {
    Axis,      ///< a direction in which nothing moves: 3D becomes 2D, a line along x becomes 1D
    Contact,   ///< an obstacle
    Damping,   ///< of all springs
    Drag,      ///< of all nodes
    Elements,  ///< a part of the model that an object's key makes: "cloth.bend"
    Motion,    ///< of nodes that hardly move: they are pinned
    Digits,    ///< springs in single precision in place of double
  };
  Kind kind = Kind::Elements;
  std::string name;             ///< "contact with 'ground'"; of Kind::Elements the part's
  int axis = 1;                 ///< of Kind::Axis, in 3D
  int dimension = 2;            ///< of Kind::Axis: what is left
  std::size_t obstacle = 0;     ///< of Kind::Contact: its index in the whole scene
  std::vector<int> nodes = {};  ///< of Kind::Motion
  std::string object = {};      ///< of Kind::Elements: the object's name in the file, and the key that makes them
  std::string key = {};
};

/// What a scene has and could be left out, whatever that does to its motion. Nodes that hardly move are
/// known only from a run, and whether digits decide anything only from what is built: see tryParts().
std::vector<Simplification> simplificationsOf(const engine::Scene& scene);

/// The scene without these: nodes keep their numbers. The one place that knows how something is left out.
engine::Scene without(const engine::Scene& scene, const std::vector<Simplification>& parts);

/// Whether all that a scene has and does lies in the plane (the line along x) that is left without a direction, so that
/// nothing ever drives it out; else the first thing that does not. Forces and motions are looked at at many times.
/// \param dimension  2: without the direction `axis`; 1: along x alone
std::string leavesPlane(const engine::Scene& scene, int axis, int dimension);

}  // namespace muelle::lab
