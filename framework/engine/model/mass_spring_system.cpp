#include "engine/model/mass_spring_system.h"

#include "engine/forces/segment.h"

#include <algorithm>
#include <limits>

namespace muelle::engine {

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
  placeFixedNodes();
  rods_ = rodsOfModel();
  countBatches();
}

/// Arrays over all nodes, with the fixed ones where the model has them.
void MassSpringSystem::placeFixedNodes() {
  zeroVelocity_.assign(static_cast<std::size_t>(size_), 0.0);
  acceleration_.assign(static_cast<std::size_t>(size_), 0.0);
  const auto all = static_cast<std::size_t>(dimension_) * model_.nodes.size();
  for (Arrays* arrays : {&first_, &second_}) {
    arrays->x.assign(all, 0.0);
    arrays->v.assign(all, 0.0);
    arrays->f.assign(all, 0.0);
  }
  for (int i = numbering_.freeNodes; i < static_cast<int>(model_.nodes.size()); ++i) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])];
    if (node.motion >= 0) moved_.push_back(i);
    for (int c = 0; c < dimension_; ++c) {
      const double x = node.x[numbering_.axes[static_cast<std::size_t>(c)]];
      first_.x[place(i, c)] = x;
      second_.x[place(i, c)] = x;
    }
  }
}

/// Gives each batch its internal variables, and counts these, guards and constraints.
void MassSpringSystem::countBatches() {
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

void MassSpringSystem::accelerationWithoutDrag(double t, In x, In v, In z, Out a) const {
  const Configuration at = gather(t, x, v, z, first_);
  double* sum = start(a);
  for (const auto& batch : batches_) batch->addForce(at, sum);
  finish(a);
  const std::span<const double> w = inverseMass();
  for (std::size_t i = 0; i < a.size(); ++i) a[i] *= w[i];
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

void MassSpringSystem::externalForce(double t, In x, In v, In z, Out f) const {
  const Configuration at = gather(t, x, v, z, first_);
  double* sum = start(f);
  for (const auto& batch : batches_) batch->addExternalForce(at, sum);
  if (drag_) drag_->addForce(at, sum);
  finish(f);
}

}  // namespace muelle::engine
