#include "engine/forces/external_force.h"

#include <algorithm>

namespace muelle::engine {

namespace {

/// How many of the times have passed; one that is reached has.
int segmentAt(const std::vector<double>& times, double t) {
  return static_cast<int>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
}

}  // namespace

template <int D>
void ExternalForce<D>::addForce(const Configuration& at, double* f) const {
  const double* own = at.z + zOffset_;
  for (const Item& item : items_) {
    int segment = 0;
    if (!item.times.empty()) {
      segment = *own > 0.0 ? static_cast<int>(*own) - 1 : segmentAt(item.times, at.t);
      ++own;
    }
    const Vector F = item.force(at.t, segment);
    for (const int node : item.nodes) Eigen::Map<Vector>(f + D * node) += F;
  }
}

template <int D>
int ExternalForce<D>::internalSize() const {
  return static_cast<int>(
      std::count_if(items_.begin(), items_.end(), [](const Item& item) { return !item.times.empty(); }));
}

template <int D>
void ExternalForce<D>::declaredTimes(double from, double to, std::vector<double>& times) const {
  for (const Item& item : items_) {
    for (const double t : item.times) {
      if (from < t && t <= to) times.push_back(t);
    }
  }
}

template <int D>
bool ExternalForce<D>::commit(const Configuration& at, bool frozen, double* z) const {
  bool changed = false;
  double* own = z + zOffset_;
  for (const Item& item : items_) {
    if (item.times.empty()) continue;
    const double now = frozen ? segmentAt(item.times, at.t) + 1 : 0;
    changed = changed || (*own > 0.0 && now != *own);
    *own++ = now;
  }
  return changed;
}

template class ExternalForce<1>;
template class ExternalForce<2>;
template class ExternalForce<3>;

}  // namespace muelle::engine
