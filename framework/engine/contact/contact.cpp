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

}  // namespace

template <int D, class Shape>
Contact<D, Shape>::Contact(ObstacleData<D> obstacle, Shape shape, ContactNodes nodes)
    : obstacle_(std::move(obstacle)), shape_(std::move(shape)), nodes_(std::move(nodes)) {
  stride_ = 1 + (Shape::hasFaces ? 1 : 0) + (hasFriction() ? FrictionMemory<D, double>::variables : 0);
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
  Vector r = layout_.at<D>(at.x, builtOf(node)) - obstacle_.centre;
  if (moves()) r -= (stopped(at) ? obstacle_.stopTime : at.t) * obstacle_.velocity;
  return r;
}

template <int D, class Shape>
Meeting<D> Contact<D, Shape>::meet(int node, const Configuration& at) const {
  const double* mine = own(node, at.z);
  Meeting<D> m;
  m.r = relativePosition(node, at);
  m.touch = shape_.touch(m.r, Shape::hasFaces ? static_cast<int>(mine[faceAt]) : 0);
  m.w = layout_.at<D>(at.v, builtOf(node));
  if (moves() && !stopped(at)) m.w -= obstacle_.velocity;
  m.N = law().asIfClosed(m.touch, m.w);
  m.acts = mine[0] == mode::live ? m.touch.gap < 0.0 : mine[0] == mode::closed;
  return m;
}

template <int D, class Shape>
void Contact<D, Shape>::addForce(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    if (!m.acts) continue;
    const double* mine = own(i, at.z);
    const double N = law().force(m, mine[0]);
    Vector F = N * m.touch.normal;
    if (hasFriction()) F += frictionOf(mine).force(m, N);
    layout_.add<D>(f, builtOf(i), F);
  }
}

template <int D, class Shape>
void Contact<D, Shape>::addForceWithoutFriction(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    if (m.acts) layout_.add<D>(f, builtOf(i), Vector(law().force(m, *own(i, at.z)) * m.touch.normal));
  }
}

template <int D, class Shape>
double Contact<D, Shape>::energy(const Configuration& at) const {
  double sum = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    if (m.acts) sum += 0.5 * obstacle_.k * m.touch.depth * m.touch.depth;
  }
  return sum;
}

template <int D, class Shape>
void Contact<D, Shape>::addConservativeForce(const Configuration& at, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    if (m.acts) layout_.add<D>(f, builtOf(i), Vector(obstacle_.k * m.touch.depth * m.touch.normal));
  }
}

template <int D, class Shape>
void Contact<D, Shape>::addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> ma = meet(i, a), mb = meet(i, b);
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
    layout_.add<D>(f, builtOf(i), Vector(0.5 * obstacle_.k * slope * n));
  }
}

template <int D, class Shape>
void Contact<D, Shape>::bind(const MatrixPattern& pattern) {
  slots_.clear();
  for (const int node : nodes_.built) slots_.push_back(pattern.slot(node, node));
}

template <int D, class Shape>
bool Contact<D, Shape>::isNotSymmetric() const {
  return hasFriction() || (obstacle_.d > 0.0 && D > 1 && std::is_same_v<Shape, Sphere<D>>);
}

template <int D, class Shape>
void Contact<D, Shape>::addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    if (!m.acts) continue;
    const double* mine = own(i, at.z);
    const double N = law().force(m, mine[0]);
    typename NormalLaw<D>::Derivatives all;
    if (N != 0.0 || mine[0] != mode::live) all = law().derivatives(m, form);
    if (hasFriction()) {
      if (!(N > 0.0)) all.dNdx.setZero(), all.dNdv.setZero();
      frictionOf(mine).addDerivatives(m, N, all.dNdx, all.dNdv, form == Form::Exact, all.K, all.damping);
    }
    addBlock<D>(values, slots_[static_cast<std::size_t>(i)], 1.0, cK * all.K + cD * all.damping);
  }
}

template <int D, class Shape>
bool Contact<D, Shape>::evaluate(int j, const Configuration& at, Constraint& out) const {
  const Meeting<D> m = meet(j, at);
  if (!m.acts || !(m.touch.depth > 0.0)) return false;
  out.kind = Constraint::Kind::Other;
  out.count = D;
  out.value = -m.touch.depth;
  out.stiffness = obstacle_.k;
  out.damping = obstacle_.d;
  for (int c = 0; c < D; ++c) {
    out.lane[static_cast<std::size_t>(c)] = layout_.lane(builtOf(j), c);
    out.gradient[static_cast<std::size_t>(c)] = m.touch.normal[c];
  }
  return true;
}

template <int D, class Shape>
void Contact<D, Shape>::project(const Configuration& at, const ConstraintProjection& projection) const {
  sweepConstraints(
      0, constraintCount(), [&](int j, Constraint& c) { return evaluate(j, at, c); }, projection);
}

template <int D, class Shape>
void Contact<D, Shape>::evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const {
  sweepConstraints(
      first, constraintCount(), [&](int j, Constraint& c) { return evaluate(j, at, c); }, blocks);
}

template <int D, class Shape>
std::string Contact<D, Shape>::leftOut() const {
  return hasFriction() ? fmt::format("friction on '{}'", obstacle_.name) : std::string();
}

template <int D, class Shape>
void Contact<D, Shape>::guards(const Configuration& at, double* g) const {
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    *g++ = law().guard(m);
    if (hasFriction()) *g++ = frictionOf(own(i, at.z)).haltGuard(m);
  }
}

template <int D, class Shape>
std::string Contact<D, Shape>::guardName(int i) const {
  const int user = nodes_.user[static_cast<std::size_t>(i / guardsPerNode())];
  if (i % guardsPerNode() == 1) return fmt::format("node {} stops slipping on '{}'", user, obstacle_.name);
  return fmt::format("node {} touches or leaves '{}'", user, obstacle_.name);
}

template <int D, class Shape>
void Contact<D, Shape>::declaredTimes(double from, double to, std::vector<double>& times) const {
  if (moves() && std::isfinite(obstacle_.stopTime) && from < obstacle_.stopTime && obstacle_.stopTime <= to) {
    times.push_back(obstacle_.stopTime);
  }
}

/// The lane along the normal, +1 or -1 of which it is; -1 where it is along none.
template <int D, class Shape>
int Contact<D, Shape>::axisOfNormal() const {
  if constexpr (std::is_same_v<Shape, Plane<D>>) {
    for (int c = 0; c < D; ++c) {
      if (std::abs(shape_.normal[c]) == 1.0) return c;
    }
  }
  return -1;
}

/// N n = -k (x - centre) - d v along the normal's lane, whichever way it points.
template <int D, class Shape>
bool Contact<D, Shape>::addLaneForces(const double* z, const LaneForces& lanes) const {
  constexpr double mostDamped = 8.0;  // times a half of the critical: beyond, the motion is nearly that of a damper
  const int axis = axisOfNormal();
  for (int node = 0; node < nodes(); ++node) {
    const double mode = *own(node, z);
    if (mode == mode::open) continue;
    const double k = obstacle_.k, d = obstacle_.d, m = nodes_.mass[static_cast<std::size_t>(node)];
    const bool inLane = mode == mode::closed && axis >= 0 && k > 0.0 && !hasFriction() && !moves();
    if (!inLane || d * d > mostDamped * mostDamped * k * m) return false;
    const int lane = layout_.lane(builtOf(node), axis);
    lanes.force[lane] += k * obstacle_.centre[axis];
    lanes.stiffness[lane] += k;
    lanes.damping[lane] += d;
  }
  return true;
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
    Meeting<D> m = meet(i, at);
    const double old = mine[0];
    mine[0] = frozen ? law().modeAfter(old, m) : mode::live;
    changed = changed || (frozen && old != mode::live && mine[0] != old);
    if (hasFriction()) {
      if (mine[0] != old) m = meet(i, at);
      const double N = law().force(m, mine[0]);
      if (frictionOf(mine).follow(m, N, nodes_.mass[static_cast<std::size_t>(i)])) atRest_.push_back(i);
    }
  }
  return changed;
}

template <int D, class Shape>
bool Contact<D, Shape>::balance(const Configuration& at, const double* f, double* z) const {
  const bool any = !atRest_.empty();
  for (const int node : atRest_) {
    const Meeting<D> m = meet(node, at);
    double* mine = own(node, z);
    const Vector load = layout_.at<D>(f, builtOf(node));
    frictionOf(mine).balance(m, law().force(m, mine[0]), load);
  }
  atRest_.clear();
  return any;
}

template <int D, class Shape>
std::string Contact<D, Shape>::eventName(int guard, const double* z) const {
  const int node = guard / guardsPerNode();
  if (guard % guardsPerNode() == 1) return guardName(guard);
  // Put together by hand: a bouncing ball does little else.
  const std::string number = std::to_string(nodes_.user[static_cast<std::size_t>(node)]);
  std::string name;
  name.reserve(20 + number.size() + obstacle_.name.size());
  name.append("node ").append(number).append(*own(node, z) == mode::closed ? " touches '" : " leaves '");
  return name.append(obstacle_.name).append(1, '\'');
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
    const Meeting<D> m = meet(i, at);
    const double own = nodes_.mass[static_cast<std::size_t>(i)];
    if (chosen >= 0 && (own > mass || (own == mass && m.touch.gap >= gap))) continue;
    chosen = i;
    mass = own;
    gap = m.touch.gap;
  }
  if (chosen < 0 || meet(chosen, at).acts) return;
  double* mine = own(chosen, z);
  if constexpr (Shape::hasFaces) mine[faceAt] = shape_.face(relativePosition(chosen, at));
  mine[0] = mode::closed;
  if (hasFriction()) frictionOf(mine).stickAt(relativePosition(chosen, at));
}

template <int D, class Shape>
double Contact<D, Shape>::shortestBounce(const Configuration& at) const {
  if (obstacle_.k <= 0.0 || nodes_.mass.empty() || isTouched(at)) return std::numeric_limits<double>::infinity();
  const double lightest = *std::min_element(nodes_.mass.begin(), nodes_.mass.end());
  return std::numbers::pi * std::sqrt(lightest / obstacle_.k);
}

template <int D, class Shape>
double Contact<D, Shape>::anchorEnergy(const Configuration& at) const {
  double sum = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    const double* mine = own(i, at.z);
    const FrictionMemory<D, const double> friction = frictionOf(mine);
    if (m.acts && !friction.isApart()) sum += friction.energy(m, law().force(m, mine[0]));
  }
  return sum;
}

template <int D, class Shape>
void Contact<D, Shape>::cross(int guard, const Configuration& at, double* z) const {
  atRest_.clear();
  const int node = guard / guardsPerNode();
  double* mine = own(node, z);
  if (guard % guardsPerNode() == 1) {
    frictionOf(mine).halt();
    atRest_.push_back(node);
    return;
  }
  if constexpr (Shape::hasFaces) {
    if (mine[0] != mode::closed) mine[faceAt] = shape_.face(relativePosition(node, at));
  }
  const Meeting<D> m = meet(node, at);
  mine[0] = law().modeBeyond(mine[0], m);
  if (hasFriction() && frictionOf(mine).isApart()) frictionOf(mine).resetAnchor(m.r);
}

template <int D, class Shape>
double Contact<D, Shape>::sweptBound(const Configuration& at, const double* a, double h) const {
  const double thickness = shape_.thickness();
  if (!std::isfinite(thickness)) return h;
  for (int i = 0; i < nodes(); ++i) {
    const Meeting<D> m = meet(i, at);
    const Vector acceleration = layout_.at<D>(a, builtOf(i));
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
