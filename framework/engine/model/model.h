#pragma once
#include "engine/elements/angle/model_angle.h"
#include "engine/elements/area/model_area.h"
#include "engine/elements/dihedral/model_dihedral.h"
#include "engine/elements/element.h"
#include "engine/elements/volume/model_volume.h"
#include "engine/kernels/precision.h"
#include "harness/types.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace muelle::engine {

/// A motion given in advance: position and velocity over time, smooth between its declared times. `segment` is the
/// number of these that have passed, frozen within a step: a method that looks beyond the step's ends sees the motion
/// go on as it does inside.
struct Motion {
  std::function<Vec3(double t, int segment)> position;  ///< [m]
  std::function<Vec3(double t, int segment)> velocity;  ///< [m/s], its derivative
  std::vector<double> times = {};                       ///< where it begins and ends [s], ascending
  std::vector<double> periods = {};  ///< [s] of each segment, infinite where it has none; empty: none has
};

/// A node as the user describes it. In 1D only the first component counts ("x" of the lecture; the height where there
/// is gravity); in 2D the two of Model::plane.
struct ModelNode {
  Vec3 x = Vec3::Zero();  ///< position [m]
  Vec3 v = Vec3::Zero();  ///< velocity [m/s]
  double m = 1.0;         ///< mass [kg]; not used when the node is pinned or moved
  bool pinned = false;    ///< stays at x
  int motion = -1;        ///< index into Model::motions of a node that is moved; -1: none
  double drag = 0.0;      ///< node damping d: F = -d v [kg/s] (slide "Amortiguamiento")
};

/// Whether nothing holds or moves the node.
inline bool isFree(const ModelNode& node) { return !node.pinned && node.motion < 0; }

/// F_a = -k (L - L0) n - dRelative (va - vb) - dProjected ((va - vb) . n) n, n = (xa - xb) / L.
struct ModelSpring {
  int a = 0, b = 1;
  double k = 1.0;           ///< [N/m], not negative
  double L0 = 1.0;          ///< [m], not negative
  double dRelative = 0.0;   ///< [kg/s]
  double dProjected = 0.0;  ///< [kg/s]
  bool unilateral = false;  ///< acts only when shorter than L0 (a contact between nodes, "rest gap")
  bool rod = false;         ///< of the constant length L0 ("k infinite"): k does not count. See checkRods()
  /// 1D only: its length is signed, xb - xa from the side on which it starts, so that it goes through its anchor as a
  /// textbook's spring does (F_a = k ((xb - xa) - L0) where b starts above a) in place of pushing to the other side.
  bool isSigned = false;
  int part = partOfItsKind;  ///< index into Model::parts
  double dampingRatio = 0;   ///< above 0 in place of dProjected, which then is 0: see projectedDamping()
};

/// A property of many nodes: E = k (p - p0)^2 / 2, p = sum_i weight_i . x_i. The mean height of n nodes has weight
/// (0, 0, 1/n) for each (slide "Fuerzas y Energias").
struct ModelProperty {
  std::vector<int> nodes;
  std::vector<Vec3> weights;
  double k = 1.0;
  double p0 = 0.0;
  int part = partOfItsKind;  ///< index into Model::parts
};

/// A force on nodes that depends on time alone, constant between its declared times, or smooth.
struct ModelExternalForce {
  std::vector<int> nodes;
  /// Force on each node [N]. `segment` is the number of declared times that have passed (frozen within a step, so that
  /// both sides of a jump are seen from their own side).
  std::function<Vec3(double t, int segment)> force;
  std::vector<double> times;         ///< where the force jumps [s], ascending
  std::vector<double> periods = {};  ///< [s] of each segment, infinite where it has none; empty: none has
  /// It may jump at other times too, which nobody knows: an adaptive method then wants a largest step, or it could pass
  /// over a pulse without seeing it.
  bool mayJump = false;
  int part = partOfItsKind;  ///< index into Model::parts
};

/// What an obstacle does to a node that goes through its surface: a penalty force k depth along the outward normal n,
/// damped by d, never pulling: F = max(0, k depth - d (v . n)) n.
struct ContactMaterial {
  double k = 1e4;            ///< [N/m]
  double d = 0.0;            ///< [kg/s]
  double mu = 0.0;           ///< coefficient of friction; the friction sticks (a spring-slider)
  double kTangential = 0.0;  ///< [N/m] of the slider; 0: as k
  double dTangential = 0.0;  ///< [kg/s] while sticking
};

/// Obstacles: half space, ball, box; a node is outside where the signed distance is positive. A slab is a box.
struct Obstacle {
  enum class Kind { Plane, Sphere, Box };
  Kind kind = Kind::Plane;
  std::string name = "ground";
  Vec3 centre = Vec3::Zero();    ///< a point of the plane, the centre of sphere or box [m]
  Vec3 normal = Vec3::UnitZ();   ///< of the plane, unit length, towards the free side
  double radius = 1.0;           ///< of the sphere [m]
  Vec3 halfSize = Vec3::Ones();  ///< of the box [m]; infinite entries make a slab
  ContactMaterial material = {};
  Vec3 velocity = Vec3::Zero();                               ///< [m/s] of the obstacle from time 0 on ...
  double stopTime = std::numeric_limits<double>::infinity();  ///< ... until this time [s]
};

/// A scene's physics as plain data, in the user's numbering. Built into a ModelSystem by build().
struct Model {
  int dimension = 3;                  ///< 1, 2 or 3 degrees of freedom a node
  std::array<int, 2> plane = {0, 2};  ///< the two axes of a 2D scene: x and z
  std::vector<ModelNode> nodes;
  std::vector<ModelSpring> springs;
  std::vector<ModelAngle> angles;
  std::vector<ModelDihedral> dihedrals;
  std::vector<ModelArea> areas;
  std::vector<ModelVolume> volumes;
  std::vector<ModelProperty> properties;
  std::vector<ModelExternalForce> externalForces;
  std::vector<Motion> motions;
  std::vector<Obstacle> obstacles;
  std::vector<std::string> parts;  ///< names that elements refer to by index, each once: "cloth.bend"
  Vec3 gravity = Vec3::Zero();     ///< acceleration [m/s^2]; (0, 0, -9.81) in 3D, and in 2D with plane {0, 2}
  /// Follow springs through zero length (an event): a spring of 1D always, in 2D and 3D only when asked for.
  bool springsCross = false;
  /// Of the springs' forces in accelerations, where springs lie on a grid of 2D or 3D. Energies, stiffness and the
  /// forces that implicit methods balance are in double throughout.
  kernels::Precision precision = kernels::Precision::Double;
  bool renumber = true;  ///< reverse Cuthill-McKee inside; results keep the user's numbering
};

/// Calls use(list) for the elements of each kind: the one list of these kinds (see elements/element.h).
template <class AnyModel, class Use>
void forEachElementKind(AnyModel& model, const Use& use) {
  use(model.angles);
  use(model.dihedrals);
  use(model.areas);
  use(model.volumes);
}

/// The struct of a list that forEachElementKind() gives.
template <class List>
using ElementOf = typename List::value_type;

/// How many elements there are, of all kinds.
inline std::size_t elementCount(const Model& model) {
  std::size_t count = 0;
  forEachElementKind(model, [&](const auto& elements) { count += elements.size(); });
  return count;
}

/// Whether one of the nodes is free: an element of held nodes moves nothing.
template <class Nodes>
bool anyFree(const Model& model, const Nodes& nodes) {
  return std::ranges::any_of(nodes, [&](int i) { return isFree(model.nodes[static_cast<std::size_t>(i)]); });
}

}  // namespace muelle::engine
