#include "engine/analysis/linearised_system.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

Eigen::Map<const Vector> map(In values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }
Eigen::Map<Vector> map(Out values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

void apply(const SystemMatrix& matrix, In y, Out out) {
  map(out).noalias() = matrix.sparse * map(y);
  if (matrix.lowRank.empty()) return;
  const Vector inner = matrix.lowRank.s.cwiseProduct(matrix.lowRank.U.transpose() * map(y));
  map(out).noalias() += matrix.lowRank.U * inner;
}

double largest(In values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

struct LinearisedSystem::Matrices {
  SystemMatrix K, D;
};

LinearisedSystem::LinearisedSystem(const DynamicalSystem& system, const State& state) : system_(system) {
  system_.follow(state);
  state_ = system_.compact(state);
  if (state_.z.empty()) state_.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  const Linearisation* linearisation = system_.linearisation();
  if (linearisation == nullptr) return;
  matrices_ = std::make_unique<Matrices>();
  const auto assemble = [&](double cD, double cK, SystemMatrix& J) {
    linearisation->assemble(0.0, cD, cK, state_.t, state_.x, state_.v, state_.z, Form::Exact, J);
  };
  assemble(0.0, 1.0, matrices_->K);
  if (!isUndamped()) assemble(1.0, 0.0, matrices_->D);
}

LinearisedSystem::~LinearisedSystem() = default;

int LinearisedSystem::size() const { return system_.size(); }

const SystemMatrix* LinearisedSystem::stiffnessMatrix() const { return matrices_ != nullptr ? &matrices_->K : nullptr; }

const SystemMatrix* LinearisedSystem::dampingMatrix() const {
  return matrices_ != nullptr && !isUndamped() ? &matrices_->D : nullptr;
}

void LinearisedSystem::difference(In y, bool ofVelocity, Out out) const {
  const std::vector<double>& base = ofVelocity ? state_.v : state_.x;
  const double scale = std::max(largest(base), ofVelocity ? 1.0 : 1e-3);
  const double step = 6e-6 * scale / std::max(largest(y), 1e-300);  // cube root of the rounding
  State moved = state_;
  std::vector<double>& entries = ofVelocity ? moved.v : moved.x;
  std::vector<double> forward(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) entries[i] = base[i] + step * y[i];
  system_.force(moved.t, moved.x, moved.v, moved.z, forward);
  for (std::size_t i = 0; i < y.size(); ++i) entries[i] = base[i] - step * y[i];
  system_.force(moved.t, moved.x, moved.v, moved.z, out);
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = (out[i] - forward[i]) / (2.0 * step);
}

void LinearisedSystem::stiffness(In y, Out out) const {
  if (matrices_ != nullptr) {
    apply(matrices_->K, y, out);
  } else {
    difference(y, false, out);
  }
}

void LinearisedSystem::damping(In y, Out out) const {
  if (isUndamped()) {
    std::fill(out.begin(), out.end(), 0.0);
  } else if (matrices_ != nullptr) {
    apply(matrices_->D, y, out);
  } else {
    difference(y, true, out);
  }
}

void LinearisedSystem::drag(In y, Out out) const {
  std::fill(out.begin(), out.end(), 0.0);
  if (system_.drag() == nullptr) return;
  const std::span<const double> d = system_.drag()->coefficients();
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = d[i] * y[i];
}

}  // namespace muelle::engine
