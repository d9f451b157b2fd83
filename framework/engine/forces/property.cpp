#include "engine/forces/property.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::engine {

Property::Property(std::vector<Entry> entries, double k, double p0, int freeSize, int userIndex)
    : entries_(std::move(entries)), k_(k), p0_(p0), userIndex_(userIndex) {
  freeEntries_ = static_cast<int>(
      std::count_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.coordinate < freeSize; }));
}

double Property::value(const double* x) const {
  double sum = 0.0;
  for (const Entry& entry : entries_) sum += entry.weight * x[entry.coordinate];
  return sum;
}

void Property::addWeights(double factor, double* f) const {
  for (const Entry& entry : entries_) f[entry.coordinate] += factor * entry.weight;
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
  for (int i = 0; i < freeEntries_; ++i) {
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    U(entry.coordinate, 0) = entry.weight;
  }
  s[0] = cK * k_;
}

bool Property::evaluateConstraint(int, const Configuration& at, int, Constraint& out) const {
  if (!(k_ > 0.0)) return false;
  out.kind = Constraint::Kind::Other;
  out.value = value(at.x) - p0_;
  out.compliance = 1.0 / k_;
  out.damping = 0.0;
  out.count = freeEntries_;
  for (std::size_t i = 0; i < static_cast<std::size_t>(freeEntries_); ++i) {
    out.unknown[i] = entries_[i].coordinate;
    out.gradient[i] = entries_[i].weight;
  }
  return true;
}

std::string Property::leftOut() const {
  return fits() ? std::string() : fmt::format("property {} of {} unknowns", userIndex_, freeEntries_);
}

}  // namespace muelle::engine
