#pragma once
#include "engine/model/model_system.h"
#include "engine/statics/curvature.h"
#include "engine/statics/imbalance.h"
#include "engine/work.h"

#include <memory>
#include <vector>

namespace muelle::engine {

/// Equilibrium with tensions as unknowns beside the positions, for springs so stiff that positions do not know them:
/// with EA / weight = 1e12 one bit of a position is a tenth of the weight.
///
/// Of each spring with stiffness k far above what the loads make of it, rho stays with the positions and the rest has a
/// tension of its own, S = (k - rho) (L - L0). Newton's method on
///
///     F(x) - sum (S + rho (L - L0)) n = 0,      L(x) - L0 - S / (k - rho) = 0
///
/// has the symmetric matrix [A N^T; N -1/(k - rho)], A the stiffness of everything else, of the tensions across the
/// springs (T/L (I - n n^T)) and rho n n^T. Its entries are of the size of the loads however large k is, and it has as
/// many negative eigenvalues as unknown tensions, and those of the stiffness matrix besides (Haynsworth 1968): A is
/// eliminated before the tensions, node by node, so LDL^T never forms k n n^T. Other springs act by their positions.
///
/// Positions carry a second double each, so that lengths are known to a part in 1e16 of themselves and not of the
/// scene.
class TensionForm {
 public:
  /// The forces of `system` at time t; `start` as the system's states, z included. The system must outlive this.
  TensionForm(const ModelSystem& system, const State& start);
  ~TensionForm();
  TensionForm(const TensionForm&) = delete;
  TensionForm& operator=(const TensionForm&) = delete;

  /// Puts the nodes at `x`, by lanes, each tension as the length says.
  void place(In x);
  /// The same with the unknown tensions given, [N] for each spring of the model.
  void place(In x, const std::vector<double>& tensions);
  /// Puts the nodes where springs of rest length 0 would hold the loads, all with the force density c / L0, and c such
  /// that the lengths are right on the average: one linear system (Schek 1974, The force density method). False where
  /// nothing pulls on springs alone: some node is not tied to a fixed one, or there is no load.
  bool placeByForceDensity();
  /// Newton's method from there, at most so many factorisations, steps halved until they do better; `pulling` keeps
  /// tensions positive on the way. Stops at round-off or where no step helps; the best shape stays.
  Imbalance solve(int mostFactorisations, bool pulling);
  Imbalance imbalance() const;
  /// The smallest eigenvalue of the stiffness matrix here.
  Curvature curvature();

  /// By lanes.
  std::vector<double> positions() const;
  /// Tension [N] of each spring of the model, in its order; positive pulls. NaN at length 0, where it has no direction;
  /// 0 where the length that says it is the rest length to round-off.
  std::vector<double> tensions() const;
  /// Springs whose tension is an unknown.
  int unknownTensions() const;
  /// Size of the loads [N]: sum over the free nodes of what acts without springs.
  double load() const;
  const Work& work() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace muelle::engine
