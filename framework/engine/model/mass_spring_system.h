#pragma once
#include "engine/forces/force_batch.h"
#include "engine/forces/node_drag.h"
#include "engine/model/few_springs.h"
#include "engine/model/grid_force.h"
#include "engine/model/model_system.h"
#include "engine/model/motion_segments.h"

#include <memory>
#include <optional>

namespace muelle::engine {

/// Which node is where. Built numbers are places: a grid may have some that hold no node.
struct Numbering {
  std::vector<int> built;      ///< built number of each of the user's nodes
  std::vector<int> user;       ///< the user's number of each built one; -1 where there is none
  std::vector<int> freeNodes;  ///< built numbers of the nodes that are neither pinned nor moved, ascending
  std::vector<int> rank;       ///< of each built node among the free ones; -1 where it is held
  std::vector<int> axes;       ///< the components of a Vec3 that the scene has, in order
  Layout layout;
};

/// The one system that build() makes: batches of forces over the lanes of all nodes, the held ones among them. The
/// dimension is a number here, and a template parameter in the batches alone. Its capabilities stand in a source each:
/// forces and energy in mass_spring_system.cpp, beside it ..._nodes, ..._matrix, ..._constraints, ..._switching and
/// ..._quantities (what a state has of energy and momentum).
class MassSpringSystem final : public ModelSystem,
                               private Potential,
                               private Drag,
                               private Linearisation,
                               private Constraints,
                               private Switching {
 public:
  /// \param drag null when no node has any; not among `batches`
  /// \param grid of the first `onGrid` batches and the drag together, where the springs are a grid
  /// \param few of all the batches together, where they are so few
  MassSpringSystem(Model model, Numbering numbering, std::vector<std::unique_ptr<ForceBatch>> batches,
                   std::unique_ptr<NodeDrag> drag, std::optional<GridForce> grid, std::size_t onGrid,
                   std::optional<FewSprings> few);

  int size() const override { return size_; }
  int storage() const override { return numbering_.layout.storage; }
  std::span<const int> lanes() const override { return lanes_; }
  std::span<const double> mass() const override { return mass_; }
  std::span<const double> inverseMass() const override { return inverseMass_; }
  /// On held nodes it is what their holders take, without the drag.
  void force(double t, In x, In v, In z, Out f) const override;
  void acceleration(double t, In x, In v, In z, Out a) const override;
  LaneMotion laneMotion(In z) const override;
  bool movesNodes() const override { return !moved_.empty(); }
  void place(double t, In z, Out x, Out v) const override;
  int internalSize() const override { return internalSize_; }
  bool forceUsesVelocity() const override;
  bool hasUnannouncedForce() const override;
  double accelerationRounding() const override { return isSingle() ? 6e-8 : DynamicalSystem::accelerationRounding(); }
  double shortestPeriod(double t) const override;
  const Potential* potential() const override { return this; }
  const Drag* drag() const override { return drag_ ? this : nullptr; }
  const Linearisation* linearisation() const override { return this; }
  const Constraints* constraints() const override { return this; }
  const Switching* switching() const override { return switches_ ? this : nullptr; }
  bool isTied() const override;
  void everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const override;
  std::span<const Rod> rods() const override { return rods_; }
  std::string unknownName(int i) const override;
  int dimension() const override { return dimension_; }

  State initialState() const override;
  int nodeCount() const override { return static_cast<int>(model_.nodes.size()); }
  Vec3 position(const State& state, int node) const override;
  Vec3 velocity(const State& state, int node) const override;
  int unknown(int node, int axis) const override;
  int lane(int node, int axis) const override;
  const Model& model() const override { return model_; }
  bool mayBeSingle() const override { return grid_.has_value() && dimension_ > 1; }
  double kineticEnergy(const State& state) const override;
  double totalEnergy(const State& state) const override;
  double elasticEnergy(const State& state) const override;
  Vec3 momentum(const State& state) const override;
  Vec3 angularMomentum(const State& state) const override;

 private:
  bool isSingle() const { return mayBeSingle() && model_.precision == kernels::Precision::Single; }
  // Potential
  bool isComplete() const override;
  double energy(double t, In x, In z) const override;
  void conservativeForce(double t, In x, In z, Out f) const override;
  void discreteGradientForce(double t, In xa, In xb, In z, Out f) const override;
  // Drag
  std::span<const double> coefficients() const override { return drag_->coefficients(); }
  void accelerationWithoutDrag(double t, In x, In v, In z, Out a) const override;
  bool remainderUsesVelocity() const override;
  // Linearisation
  void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form, SystemMatrix& J) const override;
  // Constraints
  int count() const override;
  bool onlyDistances() const override;
  void evaluate(double t, In x, In z, const ConstraintBlocks::Take& take) const override;
  void project(double t, In z, const ConstraintProjection& projection) const override;
  void externalForce(double t, In x, In v, In z, Out f) const override;
  std::string leftOut() const override;
  // Switching
  int guardCount() const override { return guardCount_; }
  void guards(double t, In x, In v, In z, Out g) const override;
  std::string guardName(int i) const override;
  std::string eventName(int i, const State& after) const override;
  void declaredTimes(double from, double to, std::vector<double>& times) const override;
  bool commit(State& state, bool frozen) const override;
  void cross(int guard, State& state) const override;
  void close(State& state) const override;
  double shortestBounce(const State& state) const override;
  double sweptBound(double t, In x, In v, In z, double h) const override;

  static Configuration configuration(double t, In x, In v, In z) { return {t, x.data(), v.data(), z.data()}; }
  /// Where a node's component stands, by its built number.
  std::size_t laneOf(int node, int component) const {
    return static_cast<std::size_t>(numbering_.layout.lane(node, component));
  }
  const ModelNode& nodeOf(int built) const {
    return model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(built)])];
  }
  void layOut();
  std::vector<Rod> rodsOfModel() const;
  void collectPieces();
  void foreseeLaneMotion();
  void findLaneMotion(In z) const;
  void requireEveryLane(Out f) const;
  void clear(Out f) const;
  void sumForces(const Configuration& at, std::size_t first, double* f) const;
  void accelerate(const Configuration& at, In x, In v, bool withDrag, Out a) const;
  int componentOf(int axis) const;
  void bind() const;
  void assembleLowRank(double cK, LowRank& lowRank) const;
  bool wantsBalance() const;
  bool balanceFriction(const Configuration& at, State& state) const;
  Vec3 vectorOf(const std::vector<double>& values, int node) const;

  Model model_;
  Numbering numbering_;
  int dimension_;
  int size_;
  int internalSize_ = 0;
  int guardCount_ = 0;
  bool switches_ = false;
  MotionSegments motionSegments_;
  std::vector<double> mass_, inverseMass_;  ///< of each lane
  std::vector<int> lanes_;                  ///< of each unknown; empty where they are the same numbers
  std::vector<double> zeroVelocity_;
  std::vector<int> moved_;  ///< built numbers of nodes with a motion
  std::vector<std::unique_ptr<ForceBatch>> batches_;
  std::unique_ptr<NodeDrag> drag_;
  std::optional<GridForce> grid_;
  std::optional<FewSprings> few_;  ///< of all batches, none of which is then asked for an acceleration
  std::size_t onGrid_;             ///< how many of the batches, from the first on, grid_ stands for
  // The pieces that the batches have, in their order, so that no batch is asked for what it has not.
  std::vector<StiffnessPiece*> stiffness_;  ///< that of the drag is the last
  std::vector<const LowRankPiece*> lowRank_;
  std::vector<const ConstraintPiece*> constraints_;
  std::vector<const SwitchingPiece*> switching_;
  std::vector<const SwitchingPiece*> guarded_;  ///< of these those with guards
  std::vector<const SwitchingPiece*> thin_;     ///< of these those with thin obstacles
  std::vector<const FrictionPiece*> friction_;
  std::vector<Rod> rods_;
  bool mayGoByLanes_ = false;   ///< nothing acts but a uniform field and what can be off, or in a lane
  std::vector<double> weight_;  ///< [N] by lanes; empty where not
  /// The last answer of laneMotion().
  struct LaneArrays {
    bool known = false;
    std::vector<double> z, force, stiffness, damping;
    LaneMotion motion;
  };
  mutable LaneArrays laneMotion_;
  mutable std::vector<double> scratch_;
  mutable std::optional<MatrixPattern> pattern_;  ///< laid out when first asked for: explicit methods never do
};

}  // namespace muelle::engine
