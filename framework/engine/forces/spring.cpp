#include "engine/forces/spring.h"

#include "engine/forces/distance_projection.h"
#include "engine/forces/length.h"
#include "engine/forces/mode.h"
#include "engine/kernels/kernel_table.h"
#include "engine/kernels/spring_groups.h"

#include <fmt/format.h>
#include <algorithm>
#include <numeric>

namespace muelle::engine {

namespace {

/// Below this multiple of L0 a length gives a direction but no usable Hessian: L0 / L would near overflow.
constexpr double shortest = 1e-100;

// Small members are `inline`: in position independent code GCC takes no other function into a loop.

}  // namespace

template <int D>
Spring<D>::Spring(const std::vector<SpringElement>& springs, SpringKind kind, const Layout& layout) : kind_(kind) {
  setLayout(layout);
  std::vector<kernels::SpringData> data;
  data.reserve(springs.size());
  for (const SpringElement& s : springs) {
    data.push_back({s.a, s.b, s.k, s.L0, s.dRelative, s.dProjected});
    if (!isSmooth()) userIndex_.push_back(s.userIndex);
    if (kind_ == SpringKind::Signed) side_.push_back(s.side);
  }
  hasMereDampers_ = std::ranges::any_of(springs, [](const SpringElement& s) { return s.k == 0.0; });
  constexpr std::size_t few = 8;  // springs, below which there is nothing to group
  // Without rest length the force is k d, exactly so here; the kernels round it.
  const bool anyLinear = std::ranges::any_of(springs, [](const SpringElement& spring) { return spring.L0 == 0.0; });
  byKernel_ = kind_ == SpringKind::Plain && !layout_.isPlanar() && (data.size() >= few || !anyLinear);
  if (byKernel_ && data.size() >= few) {
    run_ = kernels::SpringGroups(D, layout.storage / layout.node, data).runs().front();
  } else {
    run_.damping = kernels::dampingOf(data.front(), D);
    for (const kernels::SpringData& s : data) run_.append(s, D, layout.node);
  }
}

template <int D>
inline auto Spring<D>::difference(const One& s, const double* values) const -> Vector {
  return layout_.atLane<D>(values, s.a) - layout_.atLane<D>(values, s.b);
}

template <int D>
inline void Spring<D>::addPair(double* f, const One& s, const Vector& onA) const {
  layout_.addAtLane<D>(f, s.a, onA);
  layout_.addAtLane<D>(f, s.b, -onA);
}

template <int D>
void Spring<D>::addByKernel(kernels::Damping damping, const Configuration& at, double* f) const {
  kernels::kernels().addSprings[D - 1][static_cast<int>(damping)](run_.arrays(), at.x, at.v, f);
}

template <int D>
inline std::size_t Spring<D>::valuesEach() const {
  if (kind_ == SpringKind::Crossing) return D;
  return 1;
}

template <int D>
inline const double* Spring<D>::internal(std::size_t i, const double* z) const {
  return z + zOffset_ + i * valuesEach();
}

template <int D>
inline double* Spring<D>::internal(std::size_t i, double* z) const {
  return z + zOffset_ + i * valuesEach();
}

template <int D>
inline double Spring<D>::sign(std::size_t i, const Vector& d, const double* z) const {
  if (kind_ == SpringKind::Signed) return side_[i] * d[0] < 0.0 ? -1.0 : 1.0;
  if (kind_ != SpringKind::Crossing) return 1.0;
  return Eigen::Map<const Vector>(internal(i, z)).dot(d) < 0.0 ? -1.0 : 1.0;
}

template <int D>
inline bool Spring<D>::acts(std::size_t i, double L, const double* z) const {
  if (kind_ != SpringKind::Unilateral) return true;
  const double own = *internal(i, z);
  return own == mode::live ? L < run_.L0[i] : own == mode::closed;
}

template <int D>
inline double Spring<D>::signedLength(std::size_t i, const Vector& d, const double* z) const {
  return sign(i, d, z) * length<D>(d);
}

template <int D>
inline auto Spring<D>::elasticForce(std::size_t i, const Vector& d, const double* z) const -> Vector {
  const One s = one(i);
  if (D == 1 && kind_ == SpringKind::Crossing) {
    // A frozen spring goes through zero length smoothly, by its own side.
    const double own = *internal(i, z), side = own != 0.0 ? own : d[0] > 0.0 ? 1.0 : d[0] < 0.0 ? -1.0 : 0.0;
    return Vector::Constant(side == 0.0 ? 0.0 : s.k * (side * s.L0 - d[0]));
  }
  const double L = length<D>(d);
  if (L == 0.0) {
    if (kind_ == SpringKind::Signed) return Vector::Constant(s.k * s.L0 * side_[i]);
    return Vector::Zero();
  }
  if (!acts(i, L, z)) return Vector::Zero();
  const double l = sign(i, d, z) * L;
  if (L < shortest * s.L0) return -s.k * (l - s.L0) * (d / l);
  return -s.k * ((l - s.L0) / l) * d;
}

template <int D>
inline auto Spring<D>::dampingForce(const One& s, const Vector& d, const Vector& w) const -> Vector {
  Vector F = -s.dRelative * w;
  if (s.dProjected > 0.0) {
    const double L = length<D>(d);
    if (L > 0.0) {
      const Vector n = d / L;
      F -= s.dProjected * w.dot(n) * n;
    }
  }
  return F;
}

template <int D>
void Spring<D>::addForce(const Configuration& at, double* f) const {
  if (byKernel_) return addByKernel(run_.damping, at, f);
  if (!isDamped()) return addConservativeForce(at, f);
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x);
    if (kind_ == SpringKind::Unilateral && !acts(i, length<D>(d), at.z)) continue;
    const Vector F = elasticForce(i, d, at.z) + dampingForce(s, d, difference(s, at.v));
    addPair(f, s, F);
  }
}

template <int D>
void Spring<D>::addConservativeForce(const Configuration& at, double* f) const {
  if (byKernel_) return addByKernel(kernels::Damping::None, at, f);
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector F = elasticForce(i, difference(s, at.x), at.z);
    addPair(f, s, F);
  }
}

template <int D>
double Spring<D>::energy(const Configuration& at) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x);
    const double l = signedLength(i, d, at.z);
    if (acts(i, l, at.z)) sum += 0.5 * s.k * (l - s.L0) * (l - s.L0);
  }
  return sum;
}

template <int D>
void Spring<D>::addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const {
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector da = difference(s, a.x), db = difference(s, b.x);
    Vector F = Vector::Zero();
    if (kind_ == SpringKind::Unilateral) {
      // E is a function of L alone: (Ea - Eb) / (La - Lb) times (da + db) / (La + Lb) is exact.
      const double La = length<D>(da), Lb = length<D>(db);
      const bool actsA = acts(i, La, a.z), actsB = acts(i, Lb, b.z);
      const double ea = actsA ? La - s.L0 : 0.0, eb = actsB ? Lb - s.L0 : 0.0;
      // Acting at both ends the quotient is ea + eb; formed as a quotient it would be all rounding near rest.
      const bool isQuotient = actsA != actsB && std::abs(La - Lb) > 1e-12 * (La + Lb);
      const double slope = isQuotient ? (ea * ea - eb * eb) / (La - Lb) : ea + eb;
      if (La + Lb > 0.0) F = -0.5 * s.k * slope * ((da + db) / (La + Lb));
    } else if (kind_ == SpringKind::Signed) {
      F[0] = -s.k * (0.5 * (da[0] + db[0]) - side_[i] * s.L0);
    } else if (D == 1 && kind_ == SpringKind::Crossing && *internal(i, a.z) != 0.0) {
      F[0] = -s.k * (0.5 * (da[0] + db[0]) - *internal(i, a.z) * s.L0);
    } else {
      const double L = length<D>(da) + length<D>(db);
      if (L > 0.0) F = -s.k * ((L - 2.0 * s.L0) / L) * (0.5 * (da + db));
    }
    addPair(f, s, F);
  }
}

template <int D>
void Spring<D>::couple(MatrixPattern& pattern) const {
  for (std::size_t i = 0; i < run_.size(); ++i) {
    pattern.couple(std::array{run_.a[i] / layout_.node, run_.b[i] / layout_.node});
  }
}

template <int D>
void Spring<D>::bind(const MatrixPattern& pattern) {
  slots_.resize(run_.size());
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const int a = run_.a[i] / layout_.node, b = run_.b[i] / layout_.node;
    slots_[i] = {pattern.slot(a, a), pattern.slot(b, b), pattern.slot(a, b), pattern.slot(b, a)};
  }
}

template <int D>
inline auto Spring<D>::stiffness(std::size_t i, const Vector& d, const double* z, Form form) const -> Block {
  const One s = one(i);
  const double L = length<D>(d);
  if (L == 0.0 || L < shortest * s.L0) return s.k * Block::Identity();
  const double l = sign(i, d, z) * L;
  const double c = form == Form::Projected ? std::max(0.0, (l - s.L0) / l) : (l - s.L0) / l;
  const Vector n = d / L;
  return s.k * (c * (Block::Identity() - n * n.transpose()) + n * n.transpose());
}

template <int D>
void Spring<D>::addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const {
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x);
    const double L = length<D>(d);
    if (!acts(i, L, at.z)) continue;
    Block B = Block::Zero();
    if (cK != 0.0) B = cK * stiffness(i, d, at.z, form);
    if (s.dRelative > 0.0) B += cD * s.dRelative * Block::Identity();
    if (s.dProjected > 0.0 && L > 0.0) {
      const Vector n = d / L;
      B += cD * s.dProjected * n * n.transpose();
      if (form == Form::Exact && cK != 0.0) {
        const Vector w = difference(s, at.v);
        const Block P = Block::Identity() - n * n.transpose();
        B += (cK * s.dProjected / L) * (n * (P * w).transpose() + w.dot(n) * P);
      }
    }
    addBlock<D>(values, slots_[i][0], 1.0, B);
    addBlock<D>(values, slots_[i][1], 1.0, B);
    addBlock<D>(values, slots_[i][2], -1.0, B);
    addBlock<D>(values, slots_[i][3], -1.0, B);
  }
}

/// The constraint C = l - L0 of spring i and its gradient at the first node; false where it is none.
template <int D>
inline bool Spring<D>::deviation(std::size_t i, const One& s, const Configuration& at, double& C, Vector& n) const {
  const Vector d = difference(s, at.x);
  const double L = length<D>(d);
  if (s.k == 0.0 || L == 0.0 || !acts(i, L, at.z)) return false;
  const double l = sign(i, d, at.z) * L;
  n = d / l;
  C = l - s.L0;
  return true;
}

template <int D>
inline bool Spring<D>::evaluate(std::size_t i, const Configuration& at, Constraint& out) const {
  const One s = one(i);
  Vector n;
  if (!deviation(i, s, at, out.value, n)) return false;
  out.kind = Constraint::Kind::Distance;
  out.count = 2 * D;
  out.stiffness = s.k;
  out.damping = s.dProjected;
  for (std::size_t c = 0; c < D; ++c) {
    out.lane[c] = s.a + static_cast<int>(c) * layout_.component;
    out.lane[D + c] = s.b + static_cast<int>(c) * layout_.component;
    out.gradient[c] = n[static_cast<int>(c)];
    out.gradient[D + c] = -n[static_cast<int>(c)];
  }
  return true;
}

/// The numbers of the springs along the nodes, in which order a sweep goes: what one projection moves, the next takes
/// on along a chain, and not where it is in a group of the kernels.
template <int D>
const std::vector<int>& Spring<D>::alongNodes() const {
  if (alongNodes_.empty()) {
    alongNodes_.resize(run_.size());
    std::iota(alongNodes_.begin(), alongNodes_.end(), 0);
    const auto ends = [this](int i) {
      return std::minmax(run_.a[static_cast<std::size_t>(i)], run_.b[static_cast<std::size_t>(i)]);
    };
    if (byKernel_) std::ranges::sort(alongNodes_, [&](int i, int j) { return ends(i) < ends(j); });
  }
  return alongNodes_;
}

template <int D>
void Spring<D>::project(const Configuration& at, const ConstraintProjection& projection) const {
  const ConstraintProjection local = projection;  // nothing else refers to it: it stays in registers
  for (const int number : alongNodes()) {
    const auto i = static_cast<std::size_t>(number);
    const One s = one(i);
    double C = 0.0;
    Vector n;
    if (deviation(i, s, at, C, n)) {
      projectDistance<D>(local, s.a, s.b, layout_.component, n.data(), C, s.k, s.dProjected);
    }
  }
}

template <int D>
void Spring<D>::evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const {
  const std::vector<int>& along = alongNodes();
  const auto evaluateAt = [&](int j, Constraint& c) {
    return evaluate(static_cast<std::size_t>(along[static_cast<std::size_t>(j)]), at, c);
  };
  sweepConstraints(first, constraintCount(), evaluateAt, blocks);
}

template <int D>
void Spring<D>::addExternalForce(const Configuration& at, double* f) const {
  if (run_.dRelative.empty() && !hasMereDampers_) return;
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x);
    const bool constrained = s.k > 0.0 && length<D>(d) > 0.0;
    if (!acts(i, length<D>(d), at.z)) continue;
    const Vector w = difference(s, at.v);
    // The projected part belongs to the constraint wherever there is one.
    const Vector F = constrained ? Vector(-s.dRelative * w) : dampingForce(s, d, w);
    addPair(f, s, F);
  }
}

template <int D>
int Spring<D>::internalSize() const {
  return static_cast<int>(run_.size() * valuesEach());
}

template <int D>
int Spring<D>::guardCount() const {
  return static_cast<int>(run_.size());
}

template <int D>
void Spring<D>::guards(const Configuration& at, double* g) const {
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x);
    if (kind_ == SpringKind::Unilateral) {
      g[i] = length<D>(d) - run_.L0[i];
    } else {
      const Eigen::Map<const Vector> n(internal(i, at.z));
      g[i] = n.isZero(0.0) ? 1.0 : n.dot(d);
    }
  }
}

template <int D>
std::string Spring<D>::guardName(int i) const {
  const int user = userIndex_[static_cast<std::size_t>(i)];
  if (kind_ == SpringKind::Unilateral) return fmt::format("spring {} reaches its rest length", user);
  return fmt::format("spring {} passes through zero length", user);
}

template <int D>
bool Spring<D>::commit(const Configuration& at, bool frozen, double* z) const {
  bool changed = false;
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const One s = one(i);
    const Vector d = difference(s, at.x), w = difference(s, at.v);
    const double L = length<D>(d);
    double* own = internal(i, z);
    if (kind_ == SpringKind::Unilateral) {
      const double gap = L - run_.L0[i], rate = w.dot(d);
      const double old = *own;
      if (!frozen) {
        *own = mode::live;
      } else if (old == mode::live) {
        *own = gap < 0.0 || (gap == 0.0 && rate <= 0.0) ? mode::closed : mode::open;
      } else if ((old == mode::closed && gap > 0.0 && rate > 0.0) || (old == mode::open && gap < 0.0 && rate < 0.0)) {
        // On the wrong side and going further: not an event that was just located, but one that was missed.
        *own = old == mode::closed ? mode::open : mode::closed;
      }
      changed = changed || (frozen && old != mode::live && *own != old);
    } else {
      Eigen::Map<Vector> n(own);
      if (!frozen) {
        n.setZero();
      } else if (L > 0.0) {
        const bool radial = std::abs(n.dot(d)) > 0.5 * L;
        const bool arriving = radial && n.dot(d) < 0.0 && n.dot(w) > 0.0;
        changed = changed || (radial && n.dot(d) < 0.0 && !arriving);
        if (!arriving) n = d / L;
      } else if (n.isZero(0.0) && !w.isZero(0.0)) {
        n = w / length<D>(w);
      }
    }
  }
  return changed;
}

template <int D>
std::string Spring<D>::eventName(int guard, const double* z) const {
  const auto i = static_cast<std::size_t>(guard);
  if (kind_ == SpringKind::Crossing) {
    // In 1D there is no way around the anchor, and a textbook's spring would go on as it was.
    const char* then = D == 1 && run_.L0[i] > 0.0 ? " and pushes to the other side (signed = true: it does not)" : "";
    return guardName(guard) + then;
  }
  const bool closed = *internal(i, z) == mode::closed;
  return fmt::format("spring {} {} at its rest length", userIndex_[i], closed ? "begins to push" : "lets go");
}

template <int D>
void Spring<D>::close(const Configuration& /*at*/, double* z) const {
  if (kind_ != SpringKind::Unilateral) return;
  for (std::size_t i = 0; i < run_.size(); ++i) *internal(i, z) = mode::closed;
}

template <int D>
void Spring<D>::cross(int guard, const Configuration& at, double* z) const {
  const auto i = static_cast<std::size_t>(guard);
  const One s = one(i);
  const Vector d = difference(s, at.x), w = difference(s, at.v);
  double* own = internal(i, z);
  if (kind_ == SpringKind::Unilateral) {
    const double rate = w.dot(d);
    *own = rate < 0.0 ? mode::closed : rate > 0.0 ? mode::open : *own == mode::closed ? mode::open : mode::closed;
  } else {
    Eigen::Map<Vector> n(own);
    const double L = length<D>(d);
    if (L > 0.0 && std::abs(n.dot(d)) <= 0.5 * L) {
      n = d / L;  // passed beside the other end, not through it: nothing jumps
    } else if (n.dot(w) < 0.0) {
      n = -n;
    }
  }
}

template class Spring<1>;
template class Spring<2>;
template class Spring<3>;

}  // namespace muelle::engine
