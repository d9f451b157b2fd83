#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace muelle::engine {

/// One scalar constraint C(x) = 0 softened by its stiffness, as XPBD and projective dynamics take it.
struct Constraint {
  enum class Kind { Distance, Other };
  Kind kind = Kind::Other;
  int index = 0;                      ///< its number among the system's
  int count = 0;                      ///< how many of the entries below are in use
  std::array<int, 12> lane{};         ///< indices into x; a distance has node a's lanes first, then node b's
  std::array<double, 12> gradient{};  ///< dC/dx of these lanes, those of held nodes among them
  double value = 0.0;                 ///< C [m] for a distance L - L0
  double stiffness = 0.0;             ///< k, so that the energy is k C^2 / 2
  double damping = 0.0;               ///< projected damping d: force -d dC/dt along the gradient
};

/// XPBD's projection of constraints, one after another, each of which sees what those before it did to x:
///
///     dl = -(C + gamma grad C . (x - x0)) / ((1 + gamma) w + a),   a = 1 / (k h^2), gamma = d / (k h),
///
/// multiplied through by k h^2, so that k = 0 (a mere damper) is no special case. The velocity takes each correction
/// over h: (x - x0) / h would bring the rounding of x, divided by h, into the momentum. (Macklin et al. 2016, 2019.)
///
/// It is here, and not in the method, so that a batch's loop over its constraints has it inlined.
struct ConstraintProjection {
  double h;                   ///< [s] of the substep
  const double* inverseMass;  ///< [1/kg] of each lane, 0 where it is held
  const double* before;       ///< [m] x0, at the begin of the substep
  double* x;                  ///< [m]
  double* v;                  ///< [m/s]

  void operator()(const Constraint& c) const {
    double w = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      const int u = c.lane[i];
      w += c.gradient[i] * c.gradient[i] * inverseMass[u];
      if (inverseMass[u] > 0.0) moved += c.gradient[i] * (x[u] - before[u]);
    }
    const double stiffness = h * h * c.stiffness, damping = h * c.damping;
    const double multiplier = -(stiffness * c.value + damping * moved) / ((stiffness + damping) * w + 1.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
      const int u = c.lane[i];
      const double correction = multiplier * c.gradient[i] * inverseMass[u];
      x[u] += correction;
      v[u] += correction / h;
    }
  }
};

/// Collects constraints and hands them on a block at a time, so that who takes them is called once a block.
class ConstraintBlocks {
 public:
  using Take = std::function<void(std::span<const Constraint>)>;

  explicit ConstraintBlocks(const Take& take) : take_(take) {}

  void operator()(const Constraint& c) {
    block_[count_++] = c;
    if (count_ == block_.size()) flush();
  }
  /// Hands on what is left.
  void flush() {
    if (count_ > 0) take_(std::span(block_).first(count_));
    count_ = 0;
  }

 private:
  const Take& take_;
  std::array<Constraint, 32> block_;
  std::size_t count_ = 0;
};

/// Gives `use` each of `count` constraints that acts, numbered from `first` on. \param evaluate (j, constraint): fills
/// it in; false when it does not act
template <class Evaluate, class Use>
void sweepConstraints(int first, int count, const Evaluate& evaluate, Use& use) {
  Constraint constraint;
  for (int j = 0; j < count; ++j) {
    if (!evaluate(j, constraint)) continue;
    constraint.index = first + j;
    use(constraint);
  }
}

}  // namespace muelle::engine
