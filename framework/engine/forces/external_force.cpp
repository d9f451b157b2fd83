#include "engine/forces/external_force.h"

#include "engine/forces/segment.h"

#include <algorithm>

namespace muelle::engine {

template <int D>
void ExternalForce<D>::addForce(const Configuration& at, double* f) const {
  const double* own = at.z + zOffset_;
  for (const Item& item : items_) {
    const int segment = item.times.empty() ? 0 : segmentOf(*own++, item.times, at.t);
    const Vector F = item.force(at.t, segment);
    for (const int node : item.nodes) layout_.add<D>(f, node, F);
  }
}

template <int D>
int ExternalForce<D>::internalSize() const {
  return static_cast<int>(
      std::count_if(items_.begin(), items_.end(), [](const Item& item) { return !item.times.empty(); }));
}

template <int D>
void ExternalForce<D>::declaredTimes(double from, double to, std::vector<double>& times) const {
  for (const Item& item : items_) appendTimes(item.times, from, to, times);
}

template <int D>
bool ExternalForce<D>::commit(const Configuration& at, bool frozen, double* z) const {
  bool changed = false;
  double* own = z + zOffset_;
  for (const Item& item : items_) {
    if (item.times.empty()) continue;
    changed = commitSegment(*own++, item.times, at.t, frozen) || changed;
  }
  return changed;
}

template class ExternalForce<1>;
template class ExternalForce<2>;
template class ExternalForce<3>;

}  // namespace muelle::engine
