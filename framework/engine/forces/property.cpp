#include "engine/forces/property.h"

#include <fmt/format.h>

namespace muelle::engine {

Property::Property(std::vector<Entry> entries, double k, double p0, int userIndex)
    : entries_(std::move(entries)), k_(k), p0_(p0), userIndex_(userIndex) {}

double Property::value(const double* x) const {
  double sum = 0.0;
  for (const Entry& entry : entries_) sum += entry.weight * x[entry.lane];
  return sum;
}

void Property::addWeights(double factor, double* f) const {
  for (const Entry& entry : entries_) f[entry.lane] += factor * entry.weight;
}

void Property::addForce(const Configuration& at, double* f) const { addWeights(-k_ * (value(at.x) - p0_), f); }

double Property::energy(const Configuration& at) const {
  const double C = value(at.x) - p0_;
  return 0.5 * k_ * C * C;
}

void Property::addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const {
  addWeights(-k_ * (0.5 * (value(a.x) + value(b.x)) - p0_), f);
}

void Property::writeLowRank(double cK, Eigen::Ref<Eigen::MatrixXd> U, Eigen::Ref<Eigen::VectorXd> s) const {
  U.setZero();
  for (const Entry& entry : entries_) {
    if (entry.unknown >= 0) U(entry.unknown, 0) = entry.weight;
  }
  s[0] = cK * k_;
}

bool Property::evaluate(const Configuration& at, Constraint& out) const {
  if (!(k_ > 0.0)) return false;
  out.kind = Constraint::Kind::Other;
  out.value = value(at.x) - p0_;
  out.stiffness = k_;
  out.damping = 0.0;
  out.count = static_cast<int>(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    out.lane[i] = entries_[i].lane;
    out.gradient[i] = entries_[i].weight;
  }
  return true;
}

void Property::project(const Configuration& at, const ConstraintProjection& projection) const {
  sweepConstraints(
      0, constraintCount(), [&](int, Constraint& c) { return evaluate(at, c); }, projection);
}

void Property::evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const {
  sweepConstraints(
      first, constraintCount(), [&](int, Constraint& c) { return evaluate(at, c); }, blocks);
}

std::string Property::leftOut() const {
  return fits() ? std::string() : fmt::format("property {} of {} coordinates", userIndex_, entries_.size());
}

}  // namespace muelle::engine
