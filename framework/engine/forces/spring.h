#pragma once
#include "engine/forces/force_batch.h"
#include "engine/kernels/spring_run.h"

#include <array>
#include <vector>

namespace muelle::engine {

/// A spring between the nodes a and b of the built numbering.
struct SpringElement {
  int a = 0, b = 1;
  double k = 0.0;           ///< [N/m]
  double L0 = 0.0;          ///< [m]
  double dRelative = 0.0;   ///< [kg/s]
  double dProjected = 0.0;  ///< [kg/s]
  int userIndex = 0;        ///< for messages
  double side = 0.0;        ///< of SpringKind::Signed: the sign of xa - xb at its rest length
};

/// How springs act beyond their smooth range.
enum class SpringKind {
  Plain,       ///< by the distance, always
  Signed,      ///< 1D: by a length with a sign
  Crossing,    ///< may be followed through zero length; D internal variables each
  Unilateral,  ///< acts only when shorter than L0; one internal variable each
};

/// Springs of one kind and one damping form, in arrays of each coefficient: E = k (L - L0)^2 / 2, F_a = -k (L - L0) n -
/// dRelative (va - vb) - dProjected ((va - vb) . n) n with d = xa - xb, L = |d|, n = d / L (slides "Ley de Hooke",
/// "Energia Elastica", "Amortiguamiento").
///
/// Hessian: K_aa = K_bb = -K_ab = k (c I + (1 - c) n n^T), c = (L - L0) / L. Form::Projected replaces c by max(0, c),
/// which is the nearest positive semidefinite matrix. The force of projected damping depends on the positions too:
/// -dF_a/dd = (dProjected / L) (n (P w)^T + (w . n) P), P = I - n n^T, w = va - vb, in Form::Exact alone.
///
/// Zero length: the direction is undefined, so the elastic and the projected damping force are 0; the energy is
/// k L0^2 / 2; the Hessian is taken as k I (exact for L0 = 0), and so too where L < 1e-100 L0. In 1D n n^T = 1
/// everywhere, and the two dampings are the same force, at zero length too.
///
/// Through zero length, frozen: z holds the direction n0 at the last commit, and the length has the sign of d . n0:
/// F_a = -k (1 - L0 / (sign L)) d, the smooth continuation. Without internal direction (live), the sign is +.
///
/// Signed (1D): the length is side * (xa - xb) throughout, negative beyond the other end; the
/// force is linear, and nothing happens at zero length.
///
/// The force of plain springs on padded nodes is left to the kernels (engine/kernels), in whose order many of them
/// stand; all else is here, and goes through the same arrays.
///
/// Unilateral: nothing of the spring acts (damping neither) when L > L0; live by the length, frozen by the mode in z.
template <int D>
class Spring final : public ForceBatch, private StiffnessPiece, private ConstraintPiece, private SwitchingPiece {
 public:
  /// \param springs sorted along the nodes, of one damping form (kernels::dampingOf)   \param layout that of
  /// setLayout()
  Spring(const std::vector<SpringElement>& springs, SpringKind kind, const Layout& layout);

  /// The springs whose force the kernels compute; null where it is computed here.
  const kernels::SpringRun* plainRun() const { return byKernel_ ? &run_ : nullptr; }
  /// Those of 1D that may be followed through zero length, one internal variable each; null where they are others.
  const kernels::SpringRun* lineRun() const { return D == 1 && kind_ == SpringKind::Crossing ? &run_ : nullptr; }

  bool isConservative() const override { return !isDamped(); }
  bool usesVelocity() const override { return isDamped(); }
  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration& at) const override;
  void addConservativeForce(const Configuration& at, double* f) const override;
  /// The exact quotient: F_a = -k (1 - 2 L0 / (La + Lb)) (da + db) / 2 (signed lengths in 1D when frozen). A
  /// unilateral spring counts the part of its length below L0.
  void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const override;

  StiffnessPiece* stiffnessPiece() override { return this; }
  ConstraintPiece* constraintPiece() override { return this; }
  SwitchingPiece* switchingPiece() override { return isSmooth() ? nullptr : this; }

 private:
  using Vector = Eigen::Matrix<double, D, 1>;
  using Block = Eigen::Matrix<double, D, D>;

  void couple(MatrixPattern& pattern) const override;
  void bind(const MatrixPattern& pattern) override;
  void addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const override;
  bool isNotSymmetric() const override { return !run_.dProjected.empty(); }

  int constraintCount() const override { return static_cast<int>(run_.size()); }
  bool constraintsAreDistances() const override { return true; }
  void project(const Configuration& at, const ConstraintProjection& projection) const override;
  void evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const override;
  /// Relative damping acts across the spring too, which no constraint expresses.
  void addExternalForce(const Configuration& at, double* f) const override;

  int internalSize() const override;
  int guardCount() const override;
  void guards(const Configuration& at, double* g) const override;
  std::string guardName(int i) const override;
  std::string eventName(int guard, const double* z) const override;
  bool commit(const Configuration& at, bool frozen, double* z) const override;
  void cross(int guard, const Configuration& at, double* z) const override;
  void close(const Configuration& at, double* z) const override;

  /// Spring i out of the arrays, its nodes as first lanes.
  struct One {
    int a, b;
    double k, L0, dRelative, dProjected;
  };
  One one(std::size_t i) const {
    return {run_.a[i],
            run_.b[i],
            run_.k[i],
            run_.L0[i],
            run_.dRelative.empty() ? 0.0 : run_.dRelative[i],
            run_.dProjected.empty() ? 0.0 : run_.dProjected[i]};
  }

  bool isDamped() const { return run_.damping != kernels::Damping::None; }
  bool isSmooth() const { return kind_ == SpringKind::Plain || kind_ == SpringKind::Signed; }
  void addByKernel(kernels::Damping damping, const Configuration& at, double* f) const;
  void addPair(double* f, const One& s, const Vector& onA) const;
  const std::vector<int>& alongNodes() const;
  bool deviation(std::size_t i, const One& s, const Configuration& at, double& C, Vector& n) const;
  bool evaluate(std::size_t i, const Configuration& at, Constraint& out) const;
  Vector difference(const One& s, const double* values) const;
  std::size_t valuesEach() const;  // internal variables of a spring that has any
  const double* internal(std::size_t i, const double* z) const;
  double* internal(std::size_t i, double* z) const;
  double sign(std::size_t i, const Vector& d, const double* z) const;
  bool acts(std::size_t i, double L, const double* z) const;
  double signedLength(std::size_t i, const Vector& d, const double* z) const;
  Vector elasticForce(std::size_t i, const Vector& d, const double* z) const;
  Vector dampingForce(const One& s, const Vector& d, const Vector& w) const;
  Block stiffness(std::size_t i, const Vector& d, const double* z, Form form) const;

  SpringKind kind_;
  kernels::SpringRun run_;                       ///< the springs
  bool byKernel_ = false;                        ///< whether the kernels (engine/kernels) compute the force
  bool hasMereDampers_ = false;                  ///< springs of stiffness 0, which are no constraints
  std::vector<int> userIndex_;                   ///< of kinds that have events, for messages
  std::vector<double> side_;                     ///< of Signed
  std::vector<std::array<BlockSlot, 4>> slots_;  ///< aa, bb, ab, ba
  mutable std::vector<int> alongNodes_;          ///< see alongNodes(); empty until asked for
};

extern template class Spring<1>;
extern template class Spring<2>;
extern template class Spring<3>;

}  // namespace muelle::engine
