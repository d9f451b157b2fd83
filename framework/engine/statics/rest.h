#pragma once
#include "engine/model/model_system.h"
#include "engine/model/singular_points.h"
#include "engine/work.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// What a scene comes to when all of it stands still.
enum class Verdict {
  Stable,       ///< the forces balance, and every small displacement costs energy
  Saddle,       ///< the forces balance, and some displacement gains energy: it stands, but does not stay
  Neutral,      ///< the forces balance, and some displacement costs nothing as far as doubles can tell
  Unsure,       ///< the forces balance, and no matrix told how the energy curves
  Cusp,         ///< nodes lie where the energy has no gradient: there is no force to be judged
  Unsupported,  ///< nothing carries the loads
  NoneFound,    ///< the search ended where the forces do not balance
};

struct RestOptions {
  double time = 0.0;          ///< [s] at which motions, forces and obstacles are taken
  bool leaveSaddles = false;  ///< go on downhill from a saddle
  /// Of the search by positions. Where there are springs and loads alone, force densities have a go after 40 of them.
  long long mostFactorisations = 1000;
};

struct RestResult {
  Verdict verdict = Verdict::NoneFound;
  State state;                      ///< at rest, or where the search ended; v = 0
  double energy = 0.0;              ///< potential energy [J]
  std::vector<double> tensions;     ///< [N] of each spring of the model; positive pulls; NaN where it has no direction
  double residual = 0.0;            ///< largest sum of forces on a free node, springs by `tensions` [N]
  int worstNode = -1;               ///< that node, in the model's numbering
  double load = 0.0;                ///< sum over the free nodes of what acts without springs, at the start [N]
  double roundOff = 0.0;            ///< what round-off alone does to the forces on that node [N]
  int unknownTensions = 0;          ///< springs so stiff that their tension was an unknown of its own
  double lengthError = 0.0;         ///< largest |L - L0 - T/k| of these [m]
  double smallestEigenvalue = 0.0;  ///< of the stiffness matrix [N/m]; of found equilibria
  double eigenvalueRoundOff = 0.0;  ///< how far round-off may have it off [N/m]
  int negativeEigenvalues = 0;
  int softestNode = -1;   ///< where its eigenvector is largest
  bool isLowest = false;  ///< no other shape has less energy: no spring pushes, and springs and loads are all there is
  bool byForceDensity = false;  ///< found from force densities and not from the scene's start
  int saddlesLeft = 0;
  double furthest = 0.0;   ///< largest way of a node from its start [m]
  std::vector<int> nodes;  ///< on a cusp; unsupported
  std::vector<SingularPoint> cusps;
  Vec3 carried = Vec3::Zero();  ///< the load that nothing carries [N], of Unsupported
  Work work;

  /// Whether the forces balance.
  bool isFound() const { return verdict <= Verdict::Unsure; }
};

/// The equilibrium that a model comes to from its start, and what kind it is, judged by the forces and not by whether
/// the energy fell.
///
/// If Newton's method ends near the start, the scene stands there already. Else downhill from the start by positions
/// (equilibrium()). Where that does not come to an end, or the start is no shape
/// to begin with (its springs hold more energy than the loads could give: a slack chain drawn as a straight line), from
/// the shape of force densities, for models of springs and loads alone. Then Newton's method on positions and tensions
/// (TensionForm) until round-off, the verdict from the stiffness matrix there.
///
/// A balanced shape of springs and loads in which no spring pushes is one of least energy: replacing each spring's
/// energy by 0 where it would push gives a convex function that nowhere exceeds the energy and equals it there.
///
/// Friction and damping have no part in it: obstacles are smooth.
///
/// Throws std::invalid_argument for a model with a rod or a signed spring, and names it.
RestResult rest(const ModelSystem& system, const RestOptions& options = {});

}  // namespace muelle::engine
