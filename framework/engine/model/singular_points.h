#pragma once
#include "engine/model/model_system.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// A place at which the energy of a model has no gradient: however small a move from there, it decides where the force
/// points. The force that is stated there (0, or that of one side) is none to judge by.
struct SingularPoint {
  Singularity kind = Singularity::Coincident;
  /// In the user's words: "nodes 0 and 1 lie in one place, and spring 3 between them is 0.5 m long: ...".
  std::string what;
  std::vector<int> nodes;  ///< the free ones at it, in the model's numbering, ascending
};

/// Where nodes lie at such a place, to singularCloseness of the lengths around it; in the order springs, elements,
/// obstacles. Nodes that do not move and elements without stiffness make none.
/// \param places of all nodes, in the model's numbering [m]; components that the scene does not have are 0
/// \param t time, for obstacles that move [s]
std::vector<SingularPoint> singularPoints(const Model& model, const std::vector<Vec3>& places, double t);
std::vector<SingularPoint> singularPoints(const ModelSystem& system, const State& state);

}  // namespace muelle::engine
