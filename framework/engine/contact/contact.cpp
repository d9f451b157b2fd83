#include "engine/contact/contact.h"

#include "engine/contact/sweep.h"
#include "engine/forces/mode.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::engine {

namespace {

/// The obstacle's phase, when frozen.
constexpr double liveTime = 0.0, moving = 1.0, standing = 2.0;

/// What the grip of friction says.
constexpr double apart = 0.0, sticks = 1.0, slips = 2.0;

}  // namespace

template <int D, class Shape>
Contact<D, Shape>::Contact(ObstacleData<D> obstacle, Shape shape, std::vector<int> users, std::vector<double> masses)
    : obstacle_(std::move(obstacle)), shape_(std::move(shape)), users_(std::move(users)), masses_(std::move(masses)) {
  stride_ = 1 + (Shape::hasFaces ? 1 : 0) + (hasFriction() ? 1 + D : 0);
}

template <int D, class Shape>
bool Contact<D, Shape>::isConservative() const {
  return obstacle_.d == 0.0 && !hasFriction() && !moves();
}

template <int D, class Shape>
bool Contact<D, Shape>::stopped(const Configuration& at) const {
  const double phase = at.z[zOffset_];
  return phase == liveTime ? at.t >= obstacle_.stopTime : phase == standing;
}

template <int D, class Shape>
auto Contact<D, Shape>::relativePosition(int node, const Configuration& at) const -> Vector {
  Vector r = Eigen::Map<const Vector>(at.x + D * node) - obstacle_.centre;
  if (moves()) r -= (stopped(at) ? obstacle_.stopTime : at.t) * obstacle_.velocity;
  return r;
}

template <int D, class Shape>
auto Contact<D, Shape>::meet(int node, const Configuration& at) const -> Meeting {
  const double* mine = own(node, at.z);
  Meeting m;
  m.r = relativePosition(node, at);
  m.touch = shape_.touch(m.r, Shape::hasFaces ? static_cast<int>(mine[faceAt]) : 0);
  m.w = Eigen::Map<const Vector>(at.v + D * node);
  if (moves() && !stopped(at)) m.w -= obstacle_.velocity;
  m.N = obstacle_.k * m.touch.depth - obstacle_.d * m.w.dot(m.touch.normal);
  m.acts = mine[0] == mode::live ? m.touch.gap < 0.0 : mine[0] == mode::closed;
  return m;
}

/// One-sided when live.
template <int D, class Shape>
double Contact<D, Shape>::normalForce(const Meeting& m, double mode) const {
  if (!m.acts) return 0.0;
  return mode == mode::live ? std::max(0.0, m.N) : m.N;
}

/// How far behind a slipping node its anchor is put [m]: as far as the slider stretches at its limit; in a frozen slip,
/// where the anchor tells the direction of the last commit and nothing else, so far that no step turns it.
template <int D, class Shape>
double Contact<D, Shape>::stretchOf(double mode, double limit) const {
  constexpr double farAway = 1e9;
  return mode == mode::closed ? farAway : limit / obstacle_.slider.k;
}

/// The slider as it is; for a frozen slip one without a spring whose damper is that strong that it slips at any speed.
template <int D, class Shape>
Slider<D> Contact<D, Shape>::sliderOf(const Meeting& m, const double* mine, double N) const {
  const Vector& n = m.touch.normal;
  const Vector along = m.w - n * n.dot(m.w);
  const double speed = along.norm();
  if (mine[0] != mode::closed || mine[gripAt] != slips || speed == 0.0) return obstacle_.slider;
  // Past a halt within the step the force goes on as it was: the halt is an event.
  const Vector xi = m.r - Eigen::Map<const Vector>(mine + anchorAt);
  const double limit = obstacle_.slider.mu * std::fmax(N, 0.0);
  return {obstacle_.slider.mu, 0.0, (along.dot(xi) < 0.0 ? -2.0 : 2.0) * limit / speed};
}

template <int D, class Shape>
void Contact<D, Shape>::addForce(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    if (!m.acts) continue;
    const double* mine = own(i, at.z);
    const double N = normalForce(m, mine[0]);
    Eigen::Map<Vector> sum(f + D * i);
    sum += N * m.touch.normal;
    if (!hasFriction()) continue;
    const Vector xi = m.r - Eigen::Map<const Vector>(mine + anchorAt);
    sum += sliderOf(m, mine, N).grip(xi, m.w, m.touch.normal, N).force;
  }
}

template <int D, class Shape>
void Contact<D, Shape>::addForceWithoutFriction(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    if (m.acts) Eigen::Map<Vector>(f + D * i) += normalForce(m, *own(i, at.z)) * m.touch.normal;
  }
}

template <int D, class Shape>
double Contact<D, Shape>::energy(const Configuration& at) const {
  double sum = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    if (m.acts) sum += 0.5 * obstacle_.k * m.touch.depth * m.touch.depth;
  }
  return sum;
}

template <int D, class Shape>
void Contact<D, Shape>::addConservativeForce(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    if (m.acts) Eigen::Map<Vector>(f + D * i) += obstacle_.k * m.touch.depth * m.touch.normal;
  }
}

template <int D, class Shape>
void Contact<D, Shape>::addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting ma = meet(i, a), mb = meet(i, b);
    if (!ma.acts && !mb.acts) continue;
    const double ea = ma.acts ? ma.touch.depth : 0.0, eb = mb.acts ? mb.touch.depth : 0.0;
    // (ea^2 - eb^2) / (depth_a - depth_b); where one of them does not act the depths differ in sign.
    const double slope = ma.acts && mb.acts ? ea + eb : (ea * ea - eb * eb) / (ma.touch.depth - mb.touch.depth);
    // n . (xb - xa) must be depth_a - depth_b. For a ball that is the mean position over the mean distance.
    Vector n = ma.touch.normal;
    if (ma.touch.curvature > 0.0 && mb.touch.curvature > 0.0) {
      n = (ma.r + mb.r) / (1.0 / ma.touch.curvature + 1.0 / mb.touch.curvature);
    } else if (n.isZero(0.0)) {
      n = mb.touch.normal;
    }
    Eigen::Map<Vector>(f + D * i) += 0.5 * obstacle_.k * slope * n;
  }
}

template <int D, class Shape>
void Contact<D, Shape>::bind(const MatrixPattern& pattern) {
  slots_.resize(users_.size());
  for (int i = 0; i < nodes(); ++i) slots_[static_cast<std::size_t>(i)] = pattern.slot(i, i);
}

template <int D, class Shape>
bool Contact<D, Shape>::isNotSymmetric() const {
  return hasFriction() || (obstacle_.d > 0.0 && D > 1 && std::is_same_v<Shape, Sphere<D>>);
}

template <int D, class Shape>
void Contact<D, Shape>::addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    if (!m.acts) continue;
    const double* mine = own(i, at.z);
    const double N = normalForce(m, mine[0]);
    const Vector& n = m.touch.normal;
    const double curvature = m.touch.curvature;
    const Block P = Block::Identity() - n * n.transpose();
    Block K = Block::Zero(), damping = Block::Zero();
    Vector dNdx = Vector::Zero(), dNdv = Vector::Zero();
    if (N != 0.0 || mine[0] != mode::live) {
      dNdx = -obstacle_.k * n - obstacle_.d * curvature * (P * m.w);
      dNdv = -obstacle_.d * n;
      damping = obstacle_.d * n * n.transpose();
      K = obstacle_.k * n * n.transpose();
      if (form != Form::Projected) K -= obstacle_.k * m.touch.depth * curvature * P;
      if (form == Form::Exact) {
        K += obstacle_.d * curvature * (n * (P * m.w).transpose() + m.w.dot(n) * P);
      }
    }
    if (hasFriction()) {
      const Vector xi = m.r - Eigen::Map<const Vector>(mine + anchorAt);
      const Slider<D> slider = sliderOf(m, mine, N);
      const auto grip = slider.grip(xi, m.w, n, N);
      if (!(N > 0.0)) dNdx.setZero(), dNdv.setZero();
      slider.addDerivatives(grip, xi, m.w, m.touch, dNdx, dNdv, form == Form::Exact, K, damping);
    }
    addBlock<D>(values, slots_[static_cast<std::size_t>(i)], 1.0, cK * K + cD * damping);
  }
}

template <int D, class Shape>
bool Contact<D, Shape>::evaluateConstraint(int j, const Configuration& at, int, Constraint& out) const {
  const Meeting m = meet(j, at);
  if (!m.acts || !(m.touch.depth > 0.0)) return false;
  out.kind = Constraint::Kind::Other;
  out.count = D;
  out.value = -m.touch.depth;
  out.compliance = 1.0 / obstacle_.k;
  out.damping = obstacle_.d;
  for (int c = 0; c < D; ++c) {
    out.unknown[static_cast<std::size_t>(c)] = D * j + c;
    out.gradient[static_cast<std::size_t>(c)] = m.touch.normal[c];
  }
  return true;
}

template <int D, class Shape>
std::string Contact<D, Shape>::leftOut() const {
  return hasFriction() ? fmt::format("friction on '{}'", obstacle_.name) : std::string();
}

template <int D, class Shape>
double Contact<D, Shape>::guard(const Meeting& m) const {
  return obstacle_.d == 0.0 ? m.touch.gap : -std::min(-m.touch.gap, m.N / obstacle_.k);
}

template <int D, class Shape>
void Contact<D, Shape>::guards(const Configuration& at, double* g) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    *g++ = guard(m);
    if (!hasFriction()) continue;
    const double* mine = own(i, at.z);
    const bool watched = m.acts && mine[gripAt] == slips;
    const Vector xi = m.r - Eigen::Map<const Vector>(mine + anchorAt);
    const Vector& n = m.touch.normal;
    // The slip has the direction of the stretch; it ends when the velocity along it does.
    *g++ = watched ? m.w.dot(xi - n * n.dot(xi)) / std::max(length<D>(Vector(xi - n * n.dot(xi))), 1e-300) : 1.0;
  }
}

template <int D, class Shape>
std::string Contact<D, Shape>::guardName(int i) const {
  const int user = users_[static_cast<std::size_t>(i / guardsPerNode())];
  if (i % guardsPerNode() == 1) return fmt::format("node {} stops slipping on '{}'", user, obstacle_.name);
  return fmt::format("node {} touches or leaves '{}'", user, obstacle_.name);
}

template <int D, class Shape>
void Contact<D, Shape>::declaredTimes(double from, double to, std::vector<double>& times) const {
  if (moves() && std::isfinite(obstacle_.stopTime) && from < obstacle_.stopTime && obstacle_.stopTime <= to) {
    times.push_back(obstacle_.stopTime);
  }
}

/// The mode at a commit that freezes. A mode that was frozen before changes only where it is wrong and getting worse:
/// right after an event the guard is 0 but for rounding, and its sign says nothing.
template <int D, class Shape>
double Contact<D, Shape>::modeAfter(double old, const Meeting& m) const {
  const double g = guard(m), rate = m.w.dot(m.touch.normal);
  if (old == mode::live) return g < 0.0 || (g == 0.0 && rate <= 0.0) ? mode::closed : mode::open;
  const double noise = 1e-6 * (obstacle_.k * std::abs(m.touch.depth) + obstacle_.d * std::abs(rate));
  if (old == mode::closed) {
    const bool left = m.touch.gap > 0.0 && rate > 0.0;
    const bool pulls = obstacle_.d > 0.0 && m.touch.gap <= 0.0 && m.N < -noise;
    return left || pulls ? mode::open : mode::closed;
  }
  const bool pushes = m.touch.gap < 0.0 && (obstacle_.d > 0.0 ? m.N > noise : rate < 0.0);
  return pushes ? mode::closed : mode::open;
}

template <int D, class Shape>
bool Contact<D, Shape>::commit(const Configuration& at, bool frozen, double* z) const {
  atRest_.clear();
  bool changed = false;
  if (moves() && std::isfinite(obstacle_.stopTime)) {
    double& phase = z[zOffset_];
    const double now = !frozen ? liveTime : at.t >= obstacle_.stopTime ? standing : moving;
    changed = phase != liveTime && now != phase;
    phase = now;
  }
  for (int i = 0; i < nodes(); ++i) {
    double* mine = own(i, z);
    if constexpr (Shape::hasFaces) {
      const Vector r = relativePosition(i, at);
      if (mine[faceAt] == 0.0 || shape_.touch(r, 0).gap >= 0.0) {
        mine[faceAt] = shape_.face(r);
      }
    }
    Meeting m = meet(i, at);
    const double old = mine[0];
    mine[0] = frozen ? modeAfter(old, m) : mode::live;
    changed = changed || (frozen && old != mode::live && mine[0] != old);
    if (hasFriction()) {
      if (mine[0] != old) m = meet(i, at);
      commitFriction(i, m, mine);
    }
  }
  return changed;
}

/// Moves the anchor of a slider that slips, and finds the nodes that have come to rest.
template <int D, class Shape>
void Contact<D, Shape>::commitFriction(int node, const Meeting& m, double* mine) const {
  Eigen::Map<Vector> anchor(mine + anchorAt);
  const double N = normalForce(m, mine[0]);
  if (!m.acts || !(N > 0.0)) {
    mine[gripAt] = apart;
    anchor = m.r;
    return;
  }
  const Vector& n = m.touch.normal;
  const Vector along = m.w - n * n.dot(m.w);
  if (mine[gripAt] == apart) return beginFriction(node, m, along, N, mine);
  const Vector xi = m.r - anchor;
  const auto grip = sliderOf(m, mine, N).grip(xi, m.w, n, N);
  const bool turnedBack = mine[gripAt] == slips && along.dot(xi) <= 0.0;
  if (turnedBack) {
    mine[gripAt] = sticks;
    atRest_.push_back(node);
  } else if (grip.slips) {
    mine[gripAt] = slips;
    anchor = m.r + stretchOf(mine[0], grip.limit) / grip.limit * grip.force;
  } else {
    mine[gripAt] = sticks;
  }
}

/// A node that is new in contact: at rest it asks to be balanced; when it is too fast for the slider to hold, it slips
/// at once; else the slider starts without stretch.
template <int D, class Shape>
void Contact<D, Shape>::beginFriction(int node, const Meeting& m, const Vector& along, double N, double* mine) const {
  const Slider<D>& slider = obstacle_.slider;
  const double limit = slider.mu * N, square = along.squaredNorm();
  Eigen::Map<Vector> anchor(mine + anchorAt);
  anchor = m.r;
  mine[gripAt] = sticks;
  if (square == 0.0) {
    atRest_.push_back(node);
  } else if (masses_[static_cast<std::size_t>(node)] * square > limit * limit / slider.k) {
    mine[gripAt] = slips;
    anchor -= stretchOf(mine[0], limit) * along / std::sqrt(square);
  }
}

template <int D, class Shape>
bool Contact<D, Shape>::balance(const Configuration& at, const double* f, double* z) const {
  const bool any = !atRest_.empty();
  for (const int node : atRest_) {
    const Meeting m = meet(node, at);
    double* mine = own(node, z);
    const Vector& n = m.touch.normal;
    const Eigen::Map<const Vector> load(f + D * node);
    Vector wanted = n * n.dot(load) - load;
    const double limit = obstacle_.slider.mu * normalForce(m, mine[0]), size = wanted.norm();
    if (size > limit) wanted *= limit / size;
    Eigen::Map<Vector>(mine + anchorAt) = m.r + wanted / obstacle_.slider.k;
  }
  atRest_.clear();
  return any;
}

template <int D, class Shape>
std::string Contact<D, Shape>::eventName(int guard, const double* z) const {
  const int node = guard / guardsPerNode();
  if (guard % guardsPerNode() == 1) return guardName(guard);
  const char* what = *own(node, z) == mode::closed ? "touches" : "leaves";
  return fmt::format("node {} {} '{}'", users_[static_cast<std::size_t>(node)], what, obstacle_.name);
}

template <int D, class Shape>
bool Contact<D, Shape>::isTouched(const Configuration& at) const {
  for (int i = 0; i < nodes(); ++i) {
    if (meet(i, at).acts) return true;
  }
  return false;
}

/// The lightest node that does not touch yet, the nearest of these; nodes that touch stay as they are.
template <int D, class Shape>
void Contact<D, Shape>::close(const Configuration& at, double* z) const {
  int chosen = -1;
  double mass = 0.0, gap = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    const double own = masses_[static_cast<std::size_t>(i)];
    if (chosen >= 0 && (own > mass || (own == mass && m.touch.gap >= gap))) continue;
    chosen = i;
    mass = own;
    gap = m.touch.gap;
  }
  if (chosen < 0 || meet(chosen, at).acts) return;
  double* mine = own(chosen, z);
  if constexpr (Shape::hasFaces) mine[faceAt] = shape_.face(relativePosition(chosen, at));
  mine[0] = mode::closed;
  if (!hasFriction()) return;
  mine[gripAt] = sticks;
  Eigen::Map<Vector>(mine + anchorAt) = relativePosition(chosen, at);
}

template <int D, class Shape>
double Contact<D, Shape>::shortestBounce(const Configuration& at) const {
  if (obstacle_.k <= 0.0 || masses_.empty() || isTouched(at)) return std::numeric_limits<double>::infinity();
  const double lightest = *std::min_element(masses_.begin(), masses_.end());
  return std::numbers::pi * std::sqrt(lightest / obstacle_.k);
}

template <int D, class Shape>
double Contact<D, Shape>::anchorEnergy(const Configuration& at) const {
  if (!hasFriction()) return 0.0;
  double sum = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    const double* mine = own(i, at.z);
    if (!m.acts || mine[gripAt] == apart) continue;
    if (mine[gripAt] == slips) {
      const double limit = obstacle_.slider.mu * std::fmax(normalForce(m, mine[0]), 0.0);
      sum += 0.5 * limit * limit / obstacle_.slider.k;
      continue;
    }
    const Vector xi = m.r - Eigen::Map<const Vector>(mine + anchorAt);
    const double along = xi.squaredNorm() - std::pow(m.touch.normal.dot(xi), 2);
    sum += 0.5 * obstacle_.slider.k * std::max(along, 0.0);
  }
  return sum;
}

template <int D, class Shape>
void Contact<D, Shape>::cross(int guard, const Configuration& at, double* z) const {
  atRest_.clear();
  const int node = guard / guardsPerNode();
  double* mine = own(node, z);
  if (guard % guardsPerNode() == 1) {
    mine[gripAt] = sticks;
    atRest_.push_back(node);
    return;
  }
  if constexpr (Shape::hasFaces) {
    if (mine[0] != mode::closed) mine[faceAt] = shape_.face(relativePosition(node, at));
  }
  const Meeting m = meet(node, at);
  const double rate = m.w.dot(m.touch.normal);
  const double toggled = mine[0] == mode::closed ? mode::open : mode::closed;
  // Without damping the direction of motion tells the far side, whatever the mode was.
  mine[0] = obstacle_.d > 0.0 || rate == 0.0 ? toggled : rate < 0.0 ? mode::closed : mode::open;
  if (hasFriction() && mine[gripAt] == apart) Eigen::Map<Vector>(mine + anchorAt) = m.r;
}

template <int D, class Shape>
double Contact<D, Shape>::sweptBound(const Configuration& at, const double* a, double h) const {
  const double thickness = shape_.thickness();
  if (!std::isfinite(thickness)) return h;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting m = meet(i, at);
    const Eigen::Map<const Vector> acceleration(a + D * i);
    // Towards the face that the node is at now: outside, the box's own memory is of the last commit.
    const Touch<D> now = m.touch.gap > 0.0 ? shape_.touch(m.r, 0) : m.touch;
    const double time = sweptTime(now.gap, m.w.dot(now.normal), acceleration.dot(now.normal), thickness);
    h = std::min(h, time);
  }
  return h;
}

template class Contact<1, Plane<1>>;
template class Contact<2, Plane<2>>;
template class Contact<3, Plane<3>>;
template class Contact<1, Sphere<1>>;
template class Contact<2, Sphere<2>>;
template class Contact<3, Sphere<3>>;
template class Contact<1, Box<1>>;
template class Contact<2, Box<2>>;
template class Contact<3, Box<3>>;

}  // namespace muelle::engine
