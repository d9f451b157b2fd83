#pragma once
#include "engine/contact/box.h"
#include "engine/contact/friction_memory.h"
#include "engine/contact/normal_law.h"
#include "engine/contact/plane.h"
#include "engine/contact/sphere.h"
#include "engine/forces/force_batch.h"

#include <limits>

namespace muelle::engine {

/// What a contact needs to know of its obstacle besides the shape.
template <int D>
struct ObstacleData {
  using Vector = Eigen::Matrix<double, D, 1>;

  std::string name;
  Vector centre = Vector::Zero();                             ///< [m] at t = 0
  Vector velocity = Vector::Zero();                           ///< [m/s] until the stop time
  double stopTime = std::numeric_limits<double>::infinity();  ///< [s]
  double k = 0.0;                                             ///< [N/m]
  double d = 0.0;                                             ///< [kg/s]
  Slider<D> slider;                                           ///< no friction where mu is 0
};

/// The free nodes, each with its number in the built model, the user's number for messages, and its mass [kg].
struct ContactNodes {
  std::vector<int> built, user;
  std::vector<double> mass;
};

/// All free nodes against one obstacle: N = k depth - d w . n along the outward normal n, w the velocity relative to
/// the obstacle; E = k depth^2 / 2 (slide "Contacto Externo"); friction by a Slider.
///
/// Live: inside the obstacle and max(0, N). Frozen closed: N as it is, pulling beyond the surface, so that the force is
/// smooth up to the event. Frozen open: nothing. The guard of a contact is -min(-gap, N / k): a damped contact lets go
/// where N = 0, still below the surface. With friction a second guard watches a slipping node come to rest.
///
/// A node that comes to rest gets the anchor that balances all other forces on it along the surface, as far as
/// friction can: Coulomb's static friction, without the recoil of a slider that stays stretched to its limit. The
/// same is done for a node that is at rest in contact at the start. One that slides at the start, with more kinetic
/// energy than the slider can store, slips from the start.
///
/// A frozen slip has the direction of the velocity, Coulomb's: the anchor, which moves between steps alone, has no part
/// in it, so that the slip is as smooth as the motion and keeps the order of the method. (Through a halt the direction
/// goes on as it was: the halt is an event.) The anchor follows for the time when the node sticks again.
///
/// Live, the anchor stays within a step, so a step that passes over the moment of rest is pulled back along the way it
/// slid: locate events, or take steps in which a node slides little.
///
/// Hessian: k n n^T + k (-depth curvature) P inside a ball (negative: left out of Form::Projected).
/// Internal variables: the obstacle's phase; then of each node the mode, the face for a box, with friction the grip
/// (0 apart, 1 sticks, 2 slips) and the anchor relative to the obstacle.
template <int D, class Shape>
class Contact final : public ForceBatch,
                      private StiffnessPiece,
                      private ConstraintPiece,
                      private SwitchingPiece,
                      private FrictionPiece {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;
  using Block = Eigen::Matrix<double, D, D>;

  Contact(ObstacleData<D> obstacle, Shape shape, ContactNodes nodes);

  bool isConservative() const override;
  bool usesVelocity() const override { return obstacle_.d > 0.0 || hasFriction(); }
  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration& at) const override;
  void addConservativeForce(const Configuration& at, double* f) const override;
  /// The exact quotient of the energy along the depth.
  void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const override;

  StiffnessPiece* stiffnessPiece() override { return this; }
  ConstraintPiece* constraintPiece() override { return this; }
  SwitchingPiece* switchingPiece() override { return this; }
  FrictionPiece* frictionPiece() override { return hasFriction() ? this : nullptr; }

 private:
  void bind(const MatrixPattern& pattern) override;
  void addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const override;
  bool isNotSymmetric() const override;

  int constraintCount() const override { return nodes(); }
  void project(const Configuration& at, const ConstraintProjection& projection) const override;
  void evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const override;
  std::string leftOut() const override;

  int internalSize() const override { return 1 + nodes() * stride_; }
  int guardCount() const override { return nodes() * guardsPerNode(); }
  void guards(const Configuration& at, double* g) const override;
  std::string guardName(int i) const override;
  std::string eventName(int guard, const double* z) const override;
  void declaredTimes(double from, double to, std::vector<double>& times) const override;
  bool addLaneForces(const double* z, const LaneForces& lanes) const override;
  bool commit(const Configuration& at, bool frozen, double* z) const override;
  bool wantsBalance() const override { return !atRest_.empty(); }
  bool balance(const Configuration& at, const double* f, double* z) const override;
  void addForceWithoutFriction(const Configuration& at, double* f) const override;
  void cross(int guard, const Configuration& at, double* z) const override;
  void close(const Configuration& at, double* z) const override;
  double shortestBounce(const Configuration& at) const override;
  double anchorEnergy(const Configuration& at) const override;
  bool isThin() const override { return std::isfinite(shape_.thickness()); }
  double sweptBound(const Configuration& at, const double* a, double h) const override;

  bool evaluate(int j, const Configuration& at, Constraint& out) const;
  int nodes() const { return static_cast<int>(nodes_.built.size()); }
  int builtOf(int node) const { return nodes_.built[static_cast<std::size_t>(node)]; }
  bool hasFriction() const { return D > 1 && obstacle_.slider.mu > 0.0; }
  int guardsPerNode() const { return hasFriction() ? 2 : 1; }
  int axisOfNormal() const;
  bool moves() const { return !obstacle_.velocity.isZero(0.0); }
  template <class Number>
  Number* own(int node, Number* z) const {
    return z + zOffset_ + 1 + node * stride_;
  }
  static constexpr int faceAt = 1;
  static constexpr int frictionAt = Shape::hasFaces ? 2 : 1;

  bool stopped(const Configuration& at) const;
  bool isTouched(const Configuration& at) const;
  Vector relativePosition(int node, const Configuration& at) const;
  Meeting<D> meet(int node, const Configuration& at) const;
  NormalLaw<D> law() const { return {obstacle_.k, obstacle_.d}; }
  template <class Value>
  FrictionMemory<D, Value> frictionOf(Value* mine) const {
    return {obstacle_.slider, *mine, mine + frictionAt};
  }

  ObstacleData<D> obstacle_;
  Shape shape_;
  ContactNodes nodes_;
  int stride_;
  std::vector<BlockSlot> slots_;
  mutable std::vector<int> atRest_;  ///< nodes whose friction wants to be balanced
};

extern template class Contact<1, Plane<1>>;
extern template class Contact<2, Plane<2>>;
extern template class Contact<3, Plane<3>>;
extern template class Contact<1, Sphere<1>>;
extern template class Contact<2, Sphere<2>>;
extern template class Contact<3, Sphere<3>>;
extern template class Contact<1, Box<1>>;
extern template class Contact<2, Box<2>>;
extern template class Contact<3, Box<3>>;

}  // namespace muelle::engine
