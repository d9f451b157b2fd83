#include "engine/model/mass_spring_system.h"

#include "engine/forces/segment.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace muelle::engine {

MassSpringSystem::MassSpringSystem(Model model, Numbering numbering, std::vector<std::unique_ptr<ForceBatch>> batches,
                                   std::unique_ptr<NodeDrag> drag, std::optional<GridForce> grid, std::size_t onGrid,
                                   std::optional<FewSprings> few)
    : model_(std::move(model)),
      numbering_(std::move(numbering)),
      dimension_(static_cast<int>(numbering_.axes.size())),
      size_(dimension_ * static_cast<int>(numbering_.freeNodes.size())),
      motionSegments_(model_.motions),
      batches_(std::move(batches)),
      drag_(std::move(drag)),
      grid_(std::move(grid)),
      few_(std::move(few)),
      onGrid_(onGrid) {
  layOut();
  rods_ = rodsOfModel();
  collectPieces();
  foreseeLaneMotion();
}

/// Masses by lane, the lanes of the unknowns, and which nodes are moved.
void MassSpringSystem::layOut() {
  const auto storage = static_cast<std::size_t>(numbering_.layout.storage);
  for (std::vector<double>* lanes : {&mass_, &inverseMass_, &zeroVelocity_, &scratch_}) lanes->assign(storage, 0.0);
  bool isIdentity = true;
  for (const int node : numbering_.freeNodes) {
    for (int c = 0; c < dimension_; ++c) {
      const std::size_t lane = laneOf(node, c);
      mass_[lane] = nodeOf(node).m;
      inverseMass_[lane] = 1.0 / nodeOf(node).m;
      isIdentity = isIdentity && lane == lanes_.size();
      lanes_.push_back(static_cast<int>(lane));
    }
  }
  if (isIdentity) lanes_.clear();
  for (const int node : numbering_.built) {
    if (nodeOf(node).motion >= 0) moved_.push_back(node);
  }
}

/// Lists the batches' pieces, and gives those that switch their internal variables.
void MassSpringSystem::collectPieces() {
  const auto add = [](auto& list, auto* piece) {
    if (piece != nullptr) list.push_back(piece);
  };
  std::vector<double> times;
  for (const auto& batch : batches_) {
    add(stiffness_, batch->stiffnessPiece());
    add(lowRank_, batch->lowRankPiece());
    add(constraints_, batch->constraintPiece());
    add(friction_, batch->frictionPiece());
    SwitchingPiece* switching = batch->switchingPiece();
    if (switching == nullptr) continue;
    switching->setInternalOffset(internalSize_);
    internalSize_ += switching->internalSize();
    guardCount_ += switching->guardCount();
    switching_.push_back(switching);
    if (switching->guardCount() > 0) guarded_.push_back(switching);
    if (switching->isThin()) thin_.push_back(switching);
    switching->declaredTimes(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), times);
  }
  if (drag_) stiffness_.push_back(drag_->stiffnessPiece());
  motionSegments_.setInternalOffset(internalSize_);
  internalSize_ += motionSegments_.internalSize();
  switches_ = internalSize_ > 0 || guardCount_ > 0 || !times.empty();
}

/// Whether there may be motions in closed form at all, and what falls in them.
void MassSpringSystem::foreseeLaneMotion() {
  mayGoByLanes_ = !drag_ && rods_.empty() && std::ranges::all_of(batches_, [](const auto& batch) {
    return batch->isUniformField() || batch->switchingPiece() != nullptr;
  });
  if (!mayGoByLanes_) return;
  weight_.assign(mass_.size(), 0.0);
  for (const auto& batch : batches_) {
    if (batch->isUniformField()) batch->addForce({}, weight_.data());
  }
}

LaneMotion MassSpringSystem::laneMotion(In z) const {
  if (!mayGoByLanes_) return {};
  LaneArrays& lanes = laneMotion_;
  if (!lanes.known || !std::ranges::equal(z, lanes.z)) findLaneMotion(z);
  return lanes.motion;
}

void MassSpringSystem::findLaneMotion(In z) const {
  LaneArrays& lanes = laneMotion_;
  lanes.known = true;
  lanes.z.assign(z.begin(), z.end());
  lanes.force = weight_;
  lanes.stiffness.assign(mass_.size(), 0.0);
  lanes.damping.assign(mass_.size(), 0.0);
  lanes.motion = {};
  const LaneForces forces = {lanes.force.data(), lanes.stiffness.data(), lanes.damping.data()};
  const auto adds = [&](const SwitchingPiece* piece) { return piece->addLaneForces(z.data(), forces); };
  if (!std::ranges::all_of(switching_, adds)) return;
  double stiffest = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    for (double* value : {&lanes.force[i], &lanes.stiffness[i], &lanes.damping[i]}) *value *= inverseMass_[i];
    stiffest = std::max(stiffest, lanes.stiffness[i]);
  }
  lanes.motion.force = lanes.force;
  if (stiffest == 0.0) return;
  lanes.motion.stiffness = lanes.stiffness;
  lanes.motion.damping = lanes.damping;
  // A little more than a quarter of a period: a contact of a free node is over in the second such step.
  lanes.motion.longest = 1.6 / std::sqrt(stiffest);
}

std::vector<Rod> MassSpringSystem::rodsOfModel() const {
  std::vector<Rod> rods;
  for (const ModelSpring& spring : model_.springs) {
    if (!spring.rod) continue;
    Rod rod;
    rod.length = spring.L0;
    for (const auto& [node, end] : {std::pair(spring.a, &rod.a), std::pair(spring.b, &rod.b)}) {
      const int built = numbering_.built[static_cast<std::size_t>(node)];
      for (int c = 0; c < dimension_; ++c) (*end)[static_cast<std::size_t>(c)] = numbering_.layout.lane(built, c);
    }
    rods.push_back(rod);
  }
  return rods;
}

/// Batches write to every lane, those of held nodes and padding among them, by plain pointers.
void MassSpringSystem::requireEveryLane(Out f) const {
  if (f.size() != static_cast<std::size_t>(storage())) {
    throw std::invalid_argument(fmt::format("forces for {} lanes where the system has {}", f.size(), storage()));
  }
}

void MassSpringSystem::clear(Out f) const {
  requireEveryLane(f);
  std::fill(f.begin(), f.end(), 0.0);
}

/// Overwrites f with the forces of the batches from the given one on, without the drag.
void MassSpringSystem::sumForces(const Configuration& at, std::size_t first, double* f) const {
  const auto lanes = static_cast<std::size_t>(storage());
  if (first == batches_.size()) {
    std::fill_n(f, lanes, 0.0);
    return;
  }
  batches_[first]->writeForce(at, f, lanes);
  for (std::size_t i = first + 1; i < batches_.size(); ++i) batches_[i]->addForce(at, f);
}

void MassSpringSystem::force(double t, In x, In v, In z, Out f) const {
  const Configuration at = configuration(t, x, v, z);
  requireEveryLane(f);
  sumForces(at, 0, f.data());
  if (drag_) drag_->addForce(at, f.data());
}

/// Overwrites a with the accelerations, with or without the drag.
void MassSpringSystem::accelerate(const Configuration& at, In x, In v, bool withDrag, Out a) const {
  requireEveryLane(a);
  if (few_ && !(withDrag && drag_)) return few_->accelerate(at, inverseMass_, a);
  if (grid_) {
    const bool others = onGrid_ < batches_.size();
    if (others) sumForces(at, onGrid_, scratch_.data());
    return grid_->accelerate(x, v, others ? scratch_.data() : nullptr, inverseMass_, withDrag, a);
  }
  sumForces(at, 0, a.data());
  if (withDrag && drag_) drag_->addForce(at, a.data());
  for (std::size_t i = 0; i < a.size(); ++i) a[i] *= inverseMass_[i];
}

void MassSpringSystem::acceleration(double t, In x, In v, In z, Out a) const {
  accelerate(configuration(t, x, v, z), x, v, true, a);
}

void MassSpringSystem::accelerationWithoutDrag(double t, In x, In v, In z, Out a) const {
  accelerate(configuration(t, x, v, z), x, v, false, a);
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
  return static_cast<int>(numbering_.freeNodes.size()) < nodeCount() || drag_ != nullptr || !model_.obstacles.empty() ||
         !model_.properties.empty();
}

bool MassSpringSystem::isComplete() const {
  return !drag_ && moved_.empty() &&
         std::all_of(batches_.begin(), batches_.end(), [](const auto& batch) { return batch->isConservative(); });
}

double MassSpringSystem::energy(double t, In x, In z) const {
  const Configuration at = configuration(t, x, zeroVelocity_, z);
  double sum = 0.0;
  for (const auto& batch : batches_) sum += batch->energy(at);
  return sum;
}

void MassSpringSystem::conservativeForce(double t, In x, In z, Out f) const {
  const Configuration at = configuration(t, x, zeroVelocity_, z);
  clear(f);
  for (const auto& batch : batches_) batch->addConservativeForce(at, f.data());
}

void MassSpringSystem::discreteGradientForce(double t, In xa, In xb, In z, Out f) const {
  const Configuration a = configuration(t, xa, zeroVelocity_, z), b = configuration(t, xb, zeroVelocity_, z);
  clear(f);
  for (const auto& batch : batches_) batch->addDiscreteGradientForce(a, b, f.data());
}

}  // namespace muelle::engine
