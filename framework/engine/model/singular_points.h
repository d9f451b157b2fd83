#pragma once
#include "engine/model/model_system.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// A place at which the energy of a model has no gradient: however small a move from there, it decides where the force
/// points. The force that is stated there (0, or that of one side) is none to judge by.
struct SingularPoint {
  enum class Kind {
    Coincident,   ///< the ends of a spring of positive rest length
    Straight,     ///< an angle in 3D that wants to be bent: it has no side to bend to
    Folded,       ///< an angle or a dihedral that is folded back onto itself
    WithoutSize,  ///< an edge of an angle without length, a triangle of a dihedral without area
    BallCentre,   ///< of an obstacle that has a node there
  };
  Kind kind = Kind::Coincident;
  int item = -1;           ///< index of the spring, angle, dihedral or obstacle in the model
  bool isAngle = false;    ///< of Folded and WithoutSize: an angle, else a dihedral
  std::vector<int> nodes;  ///< the free ones at it, in the model's numbering, ascending
};

/// Where nodes lie at such a place, to 1e-9 of the lengths around it; in the order springs, angles, dihedrals,
/// obstacles. Nodes that do not move and elements without stiffness make none. \param places  of all nodes, in the
/// model's numbering [m]; components that the scene does not have are 0 \param t       time, for obstacles that move
/// [s]
std::vector<SingularPoint> singularPoints(const Model& model, const std::vector<Vec3>& places, double t);
std::vector<SingularPoint> singularPoints(const ModelSystem& system, const State& state);

/// In the user's words: "nodes 0 and 1 lie in one place, and spring 3 between them is 0.5 m long: ...".
std::string describe(const Model& model, const SingularPoint& point);

}  // namespace muelle::engine
