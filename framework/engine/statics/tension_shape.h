#pragma once
#include "engine/compact_system.h"
#include "engine/model/model_system.h"
#include "engine/statics/at_rest.h"
#include "engine/statics/imbalance.h"
#include "engine/statics/tension_spring.h"
#include "engine/work.h"

#include <memory>
#include <vector>

namespace muelle::engine {

/// a - b as the nearest double and the rest (Knuth, TAOCP 2, 4.2.2).
double difference(double a, double b, double& rest);

/// What of a spring's stiffness stays with the positions when its tension is an unknown, over the largest T/L.
inline constexpr double keptStiffness = 10.0;

/// A shape as TensionForm has it: positions of two doubles each, springs with their tensions, and the forces that these
/// make. What is done with it, matrices and searches, stands elsewhere.
struct TensionShape {
  using Vector = Eigen::VectorXd;

  /// The springs of `system`, and its other forces at the time of `state`. The system must outlive this.
  TensionShape(const ModelSystem& system, const State& state);

  /// Puts the nodes at x, by lanes, each tension as the length says.
  void put(In x);
  /// Works out lengths, forces and their round-off, after positions or tensions have changed.
  void measure();
  /// Makes unknowns of the tensions of springs so stiff that positions do not know them; their values stay.
  void chooseUnknownTensions();
  Imbalance imbalance() const;

  const ModelSystem& system;
  std::unique_ptr<ModelSystem> others;  ///< everything but the springs
  AtRest still;                         ///< that, with its external forces as dead loads
  CompactSystem compact;                ///< that, of its unknowns alone
  State start;                          ///< with v = 0
  int dimension;
  Eigen::Index size;  ///< number of unknown positions
  Vector hi, lo;      ///< positions: hi + lo [m]
  std::vector<TensionSpring> springs;
  Vector otherForce;           ///< of everything but the springs on each unknown [N]
  Vector otherFloor;           ///< what round-off of the positions does to it [N]; empty: no matrix has told yet
  std::vector<double> F;       ///< sum of the forces on each unknown [N]
  Vector floor;                ///< what round-off does to F [N]
  double load = 0.0;           ///< sum over the free nodes of what acts without springs, at the start [N]
  double typicalLength = 1.0;  ///< of a spring [m]
  Work work;                   ///< spent on this shape so far, matrices included

 private:
  void measureLengths();
  void addSpringForces();
};

}  // namespace muelle::engine
