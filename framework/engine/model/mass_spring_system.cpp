#include "engine/model/mass_spring_system.h"

#include "engine/forces/segment.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

namespace muelle::engine {

namespace {

/// Where a node's component stands in an array over all unknowns.
std::size_t place(int dimension, int node, int component) {
  return static_cast<std::size_t>(dimension) * static_cast<std::size_t>(node) + static_cast<std::size_t>(component);
}

/// The internal variables of a state. A recorded one has lost them: with zeros the modes are live, as the positions
/// say, and no anchor is known.
struct Modes {
  Modes(const State& state, int count)
      : live(state.z.empty() ? static_cast<std::size_t>(count) : 0, 0.0), z(state.z.empty() ? In(live) : In(state.z)) {}
  Modes(const Modes&) = delete;
  Modes& operator=(const Modes&) = delete;

  std::vector<double> live;
  In z;
};

}  // namespace

MassSpringSystem::MassSpringSystem(Model model, Numbering numbering, std::vector<std::unique_ptr<ForceBatch>> batches,
                                   std::unique_ptr<NodeDrag> drag)
    : model_(std::move(model)),
      numbering_(std::move(numbering)),
      dimension_(static_cast<int>(numbering_.axes.size())),
      size_(dimension_ * numbering_.freeNodes),
      motionSegments_(model_.motions),
      hasFixed_(numbering_.freeNodes < static_cast<int>(model_.nodes.size())),
      batches_(std::move(batches)),
      drag_(std::move(drag)) {
  mass_.reserve(static_cast<std::size_t>(size_));
  for (int i = 0; i < numbering_.freeNodes; ++i) {
    const double m = model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])].m;
    mass_.insert(mass_.end(), static_cast<std::size_t>(dimension_), m);
  }
  const auto all = static_cast<std::size_t>(dimension_) * model_.nodes.size();
  zeroVelocity_.assign(static_cast<std::size_t>(size_), 0.0);
  acceleration_.assign(static_cast<std::size_t>(size_), 0.0);
  for (Arrays* arrays : {&first_, &second_}) {
    arrays->x.assign(all, 0.0);
    arrays->v.assign(all, 0.0);
    arrays->f.assign(all, 0.0);
    for (int i = numbering_.freeNodes; i < static_cast<int>(model_.nodes.size()); ++i) {
      const ModelNode& node = model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])];
      for (int c = 0; c < dimension_; ++c) {
        arrays->x[place(dimension_, i, c)] = node.x[numbering_.axes[static_cast<std::size_t>(c)]];
      }
    }
  }
  for (int i = numbering_.freeNodes; i < static_cast<int>(model_.nodes.size()); ++i) {
    if (model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])].motion >= 0) {
      moved_.push_back(i);
    }
  }
  rods_ = rodsOfModel();
  constraintStart_.push_back(0);
  std::vector<double> times;
  for (const auto& batch : batches_) {
    batch->setInternalOffset(internalSize_);
    internalSize_ += batch->internalSize();
    guardCount_ += batch->guardCount();
    constraintStart_.push_back(constraintStart_.back() + batch->constraintCount());
    batch->declaredTimes(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), times);
  }
  motionSegments_.setInternalOffset(internalSize_);
  internalSize_ += motionSegments_.internalSize();
  switches_ = internalSize_ > 0 || guardCount_ > 0 || !times.empty();
}

void MassSpringSystem::setFixed(double t, In z, Arrays& arrays) const {
  for (const int i : moved_) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])];
    const auto index = static_cast<std::size_t>(node.motion);
    const Motion& motion = model_.motions[index];
    const int segment = motionSegments_.at(index, t, z);
    const Vec3 x = motion.position(t, segment), v = motion.velocity(t, segment);
    for (int c = 0; c < dimension_; ++c) {
      const int axis = numbering_.axes[static_cast<std::size_t>(c)];
      arrays.x[place(dimension_, i, c)] = x[axis];
      arrays.v[place(dimension_, i, c)] = v[axis];
    }
  }
}

Configuration MassSpringSystem::gather(double t, In x, In v, In z, Arrays& arrays) const {
  if (!hasFixed_) return {t, x.data(), v.data(), z.data()};
  std::copy(x.begin(), x.end(), arrays.x.begin());
  std::copy(v.begin(), v.end(), arrays.v.begin());
  setFixed(t, z, arrays);
  return {t, arrays.x.data(), arrays.v.data(), z.data()};
}

std::vector<Rod> MassSpringSystem::rodsOfModel() const {
  std::vector<Rod> rods;
  for (const ModelSpring& spring : model_.springs) {
    if (!spring.rod) continue;
    Rod rod;
    rod.length = spring.L0;
    for (const auto& [node, end] : {std::pair(spring.a, &rod.a), std::pair(spring.b, &rod.b)}) {
      const int built = numbering_.built[static_cast<std::size_t>(node)];
      if (built < numbering_.freeNodes) {
        *end = dimension_ * built;
        continue;
      }
      for (std::size_t c = 0; c < numbering_.axes.size(); ++c) {
        rod.held[c] = model_.nodes[static_cast<std::size_t>(node)].x[numbering_.axes[c]];
      }
    }
    rods.push_back(rod);
  }
  return rods;
}

/// The array that the batches add to: the caller's, or one with room for the fixed nodes.
double* MassSpringSystem::start(Out f) const {
  std::fill(f.begin(), f.end(), 0.0);
  if (!hasFixed_) return f.data();
  std::fill(first_.f.begin(), first_.f.end(), 0.0);
  return first_.f.data();
}

void MassSpringSystem::finish(Out f) const {
  if (hasFixed_) std::copy_n(first_.f.begin(), f.size(), f.begin());
}

void MassSpringSystem::force(double t, In x, In v, In z, Out f) const {
  const Configuration at = gather(t, x, v, z, first_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addForce(at, sum);
  if (drag_) drag_->addForce(at, sum);
  finish(f);
}

void MassSpringSystem::forceWithoutDrag(double t, In x, In v, In z, Out f) const {
  const Configuration at = gather(t, x, v, z, first_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addForce(at, sum);
  finish(f);
}

double MassSpringSystem::shortestPeriod(double t) const {
  double shortest = std::numeric_limits<double>::infinity();
  const auto take = [&](const auto& item) { shortest = std::min(shortest, periodAt(item.periods, item.times, t)); };
  std::ranges::for_each(model_.externalForces, take);
  std::ranges::for_each(model_.motions, take);
  return shortest;
}

bool MassSpringSystem::hasUnannouncedForce() const {
  return std::ranges::any_of(model_.externalForces, &ModelExternalForce::mayJump);
}

bool MassSpringSystem::forceUsesVelocity() const { return drag_ != nullptr || remainderUsesVelocity(); }

bool MassSpringSystem::remainderUsesVelocity() const {
  return std::any_of(batches_.begin(), batches_.end(), [](const auto& batch) { return batch->usesVelocity(); });
}

bool MassSpringSystem::isTied() const {
  return hasFixed_ || drag_ != nullptr || !model_.obstacles.empty() || !model_.properties.empty();
}

void MassSpringSystem::everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const {
  x = state.x;
  v = state.v;
  if (!hasFixed_) return;
  gather(state.t, state.x, state.v, state.z, first_);
  x = first_.x;
  v = first_.v;
}

std::string MassSpringSystem::unknownName(int i) const {
  const int axis = numbering_.axes[static_cast<std::size_t>(i % dimension_)];
  return fmt::format("node {}, {}", numbering_.user[static_cast<std::size_t>(i / dimension_)], "xyz"[axis]);
}

bool MassSpringSystem::isComplete() const {
  return !drag_ && moved_.empty() &&
         std::all_of(batches_.begin(), batches_.end(), [](const auto& batch) { return batch->isConservative(); });
}

double MassSpringSystem::energy(double t, In x, In z) const {
  const Configuration at = gather(t, x, zeroVelocity_, z, first_);
  double sum = 0.0;
  for (const auto& batch : batches_) sum += batch->energy(at);
  return sum;
}

void MassSpringSystem::conservativeForce(double t, In x, In z, Out f) const {
  const Configuration at = gather(t, x, zeroVelocity_, z, first_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addConservativeForce(at, sum);
  finish(f);
}

void MassSpringSystem::discreteGradientForce(double t, In xa, In xb, In z, Out f) const {
  const Configuration a = gather(t, xa, zeroVelocity_, z, first_), b = gather(t, xb, zeroVelocity_, z, second_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addDiscreteGradientForce(a, b, sum);
  finish(f);
}

void MassSpringSystem::bind() const {
  pattern_.emplace(dimension_, numbering_.freeNodes);
  for (const auto& batch : batches_) batch->couple(*pattern_);
  pattern_->finish();
  for (const auto& batch : batches_) batch->bind(*pattern_);
  if (drag_) drag_->bind(*pattern_);
}

void MassSpringSystem::assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form,
                                SystemMatrix& J) const {
  if (!pattern_) bind();
  pattern_->clear(J.sparse);
  const Configuration at = gather(t, x, v, z, first_);
  double* values = J.sparse.valuePtr();
  J.symmetric = true;
  for (const auto& batch : batches_) {
    batch->addDerivatives(at, cD, cK, form, values);
    if (form == Form::Exact && batch->isNotSymmetric()) J.symmetric = false;
  }
  if (drag_) drag_->addDerivatives(at, cD, cK, form, values);
  if (cM != 0.0) {
    for (int node = 0; node < numbering_.freeNodes; ++node) {
      const BlockSlot slot = pattern_->slot(node, node);
      for (int axis = 0; axis < dimension_; ++axis) {
        values[slot.base + axis * slot.stride + axis] += cM * mass_[place(dimension_, node, axis)];
      }
    }
  }
  int columns = 0;
  for (const auto& batch : batches_) columns += batch->lowRankColumns();
  J.lowRank.U.resize(columns == 0 ? 0 : size_, columns);
  J.lowRank.s.resize(columns);
  int column = 0;
  for (const auto& batch : batches_) {
    const int own = batch->lowRankColumns();
    if (own == 0) continue;
    batch->writeLowRank(cK, J.lowRank.U.middleCols(column, own), J.lowRank.s.segment(column, own));
    column += own;
  }
}

bool MassSpringSystem::onlyDistances() const {
  return std::ranges::all_of(
      batches_, [](const auto& batch) { return batch->constraintCount() == 0 || batch->constraintsAreDistances(); });
}

void MassSpringSystem::extend(double t, In x, std::vector<double>& all) const {
  const Configuration at = gather(t, x, zeroVelocity_, {}, first_);
  all.assign(at.x, at.x + (hasFixed_ ? first_.x.size() : x.size()));
}

bool MassSpringSystem::evaluate(int j, double t, In x, In z, Constraint& out) const {
  const bool extended = x.size() > static_cast<std::size_t>(size_);
  const Configuration at =
      extended ? Configuration{t, x.data(), first_.v.data(), z.data()} : gather(t, x, zeroVelocity_, z, first_);
  const auto next = std::upper_bound(constraintStart_.begin(), constraintStart_.end(), j);
  const auto batch = static_cast<std::size_t>(next - constraintStart_.begin()) - 1;
  return batches_[batch]->evaluateConstraint(j - constraintStart_[batch], at, size_, out);
}

void MassSpringSystem::externalForce(double t, In x, In v, In z, Out f) const {
  const Configuration at = gather(t, x, v, z, first_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addExternalForce(at, sum);
  if (drag_) drag_->addForce(at, sum);
  finish(f);
}

std::string MassSpringSystem::leftOut() const {
  std::string all;
  for (const auto& batch : batches_) {
    const std::string own = batch->leftOut();
    if (!own.empty()) all += (all.empty() ? "" : ", ") + own;
  }
  return all;
}

void MassSpringSystem::guards(double t, In x, In v, In z, Out g) const {
  const Configuration at = gather(t, x, v, z, first_);
  std::size_t next = 0;
  for (const auto& batch : batches_) {
    batch->guards(at, g.data() + next);
    next += static_cast<std::size_t>(batch->guardCount());
  }
}

std::string MassSpringSystem::guardName(int i) const {
  for (const auto& batch : batches_) {
    if (i < batch->guardCount()) return batch->guardName(i);
    i -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::declaredTimes(double from, double to, std::vector<double>& times) const {
  std::vector<double> own;
  for (const auto& batch : batches_) batch->declaredTimes(from, to, own);
  motionSegments_.declaredTimes(from, to, own);
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  times.insert(times.end(), own.begin(), own.end());
}

bool MassSpringSystem::commit(State& state, bool frozen) const {
  bool changed = false;
  if (static_cast<int>(state.z.size()) != internalSize_) {
    state.z.assign(static_cast<std::size_t>(internalSize_), 0.0);
    changed = true;
  }
  changed = motionSegments_.commit(state.t, frozen, state.z.data()) || changed;
  const Configuration at = gather(state.t, state.x, state.v, state.z, first_);
  bool balance = false;
  for (const auto& batch : batches_) {
    changed = batch->commit(at, frozen, state.z.data()) || changed;
    balance = balance || batch->wantsBalance();
  }
  if (balance) changed = balanceFriction(at, state) || changed;
  return changed;
}

/// Second part of a commit: gives friction at rest what the other forces ask of it.
bool MassSpringSystem::balanceFriction(const Configuration& at, State& state) const {
  bool changed = false;
  double* sum = second_.f.data();
  std::fill(second_.f.begin(), second_.f.end(), 0.0);
  for (const auto& batch : batches_) batch->addForceWithoutFriction(at, sum);
  if (drag_) drag_->addForce(at, sum);
  for (const auto& batch : batches_) changed = batch->balance(at, sum, state.z.data()) || changed;
  return changed;
}

void MassSpringSystem::cross(int guard, State& state) const {
  const Configuration at = gather(state.t, state.x, state.v, state.z, first_);
  for (const auto& batch : batches_) {
    if (guard < batch->guardCount()) {
      batch->cross(guard, at, state.z.data());
      if (batch->wantsBalance()) balanceFriction(at, state);
      return;
    }
    guard -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

std::string MassSpringSystem::eventName(int i, const State& after) const {
  for (const auto& batch : batches_) {
    if (i < batch->guardCount()) return batch->eventName(i, after.z.data());
    i -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::close(State& state) const {
  state.z.resize(static_cast<std::size_t>(internalSize_), 0.0);
  const std::vector<double> before = state.z;
  const Configuration at = gather(state.t, state.x, state.v, before, first_);
  for (const auto& batch : batches_) batch->close(at, state.z.data());
}

double MassSpringSystem::shortestBounce(const State& state) const {
  const Modes modes(state, internalSize_);
  const Configuration at = gather(state.t, state.x, state.v, modes.z, first_);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& batch : batches_) shortest = std::min(shortest, batch->shortestBounce(at));
  return shortest;
}

double MassSpringSystem::sweptBound(double t, In x, In v, In z, double h) const {
  if (std::none_of(batches_.begin(), batches_.end(), [](const auto& batch) { return batch->isThin(); })) return h;
  force(t, x, v, z, acceleration_);
  for (std::size_t i = 0; i < acceleration_.size(); ++i) acceleration_[i] /= mass_[i];
  const Configuration at = gather(t, x, v, z, first_);
  for (const auto& batch : batches_) h = batch->sweptBound(at, acceleration_.data(), h);
  return h;
}

State MassSpringSystem::initialState() const {
  State state;
  state.x.resize(static_cast<std::size_t>(size_));
  state.v.resize(static_cast<std::size_t>(size_));
  for (int i = 0; i < size_; ++i) {
    const ModelNode& node =
        model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i / dimension_)])];
    const int axis = numbering_.axes[static_cast<std::size_t>(i % dimension_)];
    state.x[static_cast<std::size_t>(i)] = node.x[axis];
    state.v[static_cast<std::size_t>(i)] = node.v[axis];
  }
  commit(state, false);
  return state;
}

Vec3 MassSpringSystem::component(const State& state, int node, bool velocity) const {
  const int built = numbering_.built.at(static_cast<std::size_t>(node));
  Vec3 result = Vec3::Zero();
  if (built >= numbering_.freeNodes) {
    const ModelNode& fixed = model_.nodes[static_cast<std::size_t>(node)];
    Vec3 full = velocity ? Vec3(Vec3::Zero()) : fixed.x;
    if (fixed.motion >= 0) {
      const auto index = static_cast<std::size_t>(fixed.motion);
      const Motion& motion = model_.motions[index];
      const int segment = motionSegments_.at(index, state.t, state.z);
      full = velocity ? motion.velocity(state.t, segment) : motion.position(state.t, segment);
    }
    for (const int axis : numbering_.axes) result[axis] = full[axis];
    return result;
  }
  const std::vector<double>& values = velocity ? state.v : state.x;
  for (int c = 0; c < dimension_; ++c) {
    result[numbering_.axes[static_cast<std::size_t>(c)]] = values[place(dimension_, built, c)];
  }
  return result;
}

Vec3 MassSpringSystem::position(const State& state, int node) const { return component(state, node, false); }

Vec3 MassSpringSystem::velocity(const State& state, int node) const { return component(state, node, true); }

int MassSpringSystem::unknown(int node, int axis) const {
  if (node < 0 || node >= nodeCount()) {
    throw std::out_of_range(fmt::format("there is no node {}; nodes are 0 to {}", node, nodeCount() - 1));
  }
  const auto place = std::find(numbering_.axes.begin(), numbering_.axes.end(), axis);
  if (place == numbering_.axes.end()) {
    throw std::out_of_range(fmt::format("axis {} is none of this {}D scene", axis, dimension_));
  }
  const int built = numbering_.built[static_cast<std::size_t>(node)];
  if (built >= numbering_.freeNodes) return -1;
  return dimension_ * built + static_cast<int>(place - numbering_.axes.begin());
}

double MassSpringSystem::kineticEnergy(const State& state) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) sum += 0.5 * mass_[i] * state.v[i] * state.v[i];
  return sum;
}

double MassSpringSystem::totalEnergy(const State& state) const {
  const Modes modes(state, internalSize_);
  double sum = kineticEnergy(state) + energy(state.t, state.x, modes.z);
  const Configuration at = gather(state.t, state.x, zeroVelocity_, modes.z, first_);
  for (const auto& batch : batches_) sum += state.z.empty() ? 0.0 : batch->anchorEnergy(at);
  return sum;
}

double MassSpringSystem::elasticEnergy(const State& state) const {
  const Modes modes(state, internalSize_);
  const Configuration at = gather(state.t, state.x, zeroVelocity_, modes.z, first_);
  double sum = 0.0;
  for (const auto& batch : batches_) sum += batch->isUniformField() ? 0.0 : batch->energy(at);
  return sum;
}

Vec3 MassSpringSystem::momentum(const State& state) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < nodeCount(); ++i) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(i)];
    if (isFree(node)) sum += node.m * velocity(state, i);
  }
  return sum;
}

Vec3 MassSpringSystem::angularMomentum(const State& state) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < nodeCount(); ++i) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(i)];
    if (isFree(node)) sum += node.m * position(state, i).cross(velocity(state, i));
  }
  return sum;
}

}  // namespace muelle::engine
