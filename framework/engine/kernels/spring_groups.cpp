#include "engine/kernels/spring_groups.h"

#include "engine/kernels/kernel_table.h"

#include <algorithm>
#include <array>

namespace muelle::engine::kernels {

namespace {

constexpr std::size_t groupSize = 8;
/// How far a group looks ahead for a spring that fits: far enough for nodes with some tens of springs, and near enough
/// that what it takes is still in the cache.
constexpr std::size_t window = 256;

/// Puts springs into an order in which each eight have no node in common. Where the window has none that fits, the next
/// one is taken: the loops add one spring after another, so that costs time alone.
class Grouper {
 public:
  Grouper(std::span<const SpringData> springs, int nodes)
      : springs_(springs), groupOfNode_(static_cast<std::size_t>(nodes), -1) {}

  /// \param candidates numbers of springs, sorted along the nodes; reordered
  void group(std::vector<int>& candidates) {
    std::vector<int> grouped;
    grouped.reserve(candidates.size());
    std::vector<char> isTaken(candidates.size());
    std::size_t first = 0;
    while (grouped.size() < candidates.size()) {
      const std::size_t full = std::min(grouped.size() + groupSize, candidates.size());
      ++group_;
      for (const bool mayShare : {false, true}) {
        const std::size_t end = std::min(first + window, candidates.size());
        for (std::size_t i = first; i < end && grouped.size() < full; ++i) {
          if (isTaken[i] || (!mayShare && isMet(candidates[i]))) continue;
          isTaken[i] = 1;
          mark(candidates[i]);
          grouped.push_back(candidates[i]);
        }
      }
      while (first < candidates.size() && isTaken[first]) ++first;
    }
    candidates = std::move(grouped);
  }

 private:
  const SpringData& spring(int i) const { return springs_[static_cast<std::size_t>(i)]; }
  int& groupOf(int node) { return groupOfNode_[static_cast<std::size_t>(node)]; }
  bool isMet(int i) { return groupOf(spring(i).a) == group_ || groupOf(spring(i).b) == group_; }
  void mark(int i) { groupOf(spring(i).a) = groupOf(spring(i).b) = group_; }

  std::span<const SpringData> springs_;
  std::vector<int> groupOfNode_;  ///< the last group that it was in
  int group_ = -1;
};

}  // namespace

SpringGroups::SpringGroups(int dimension, int nodes, std::span<const SpringData> springs) : dimension_(dimension) {
  std::array<std::vector<int>, dampingForms> byForm;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    if (springs[i].a == springs[i].b) continue;
    byForm[static_cast<std::size_t>(dampingOf(springs[i], dimension))].push_back(static_cast<int>(i));
  }
  Grouper grouper(springs, nodes);
  for (std::size_t form = 0; form < byForm.size(); ++form) {
    std::vector<int>& chosen = byForm[form];
    if (chosen.empty()) continue;
    const auto ends = [&](int i) {
      const SpringData& s = springs[static_cast<std::size_t>(i)];
      return std::minmax(s.a, s.b);
    };
    std::stable_sort(chosen.begin(), chosen.end(), [&](int i, int j) { return ends(i) < ends(j); });
    grouper.group(chosen);
    SpringRun& run = runs_.emplace_back();
    run.damping = static_cast<Damping>(form);
    for (const int i : chosen)
      run.append(springs[static_cast<std::size_t>(i)], dimension, dimension == 3 ? 4 : dimension);
    order_.insert(order_.end(), chosen.begin(), chosen.end());
  }
}

void SpringGroups::addForce(const double* x, const double* v, double* f) const {
  for (const SpringRun& run : runs_) {
    kernels().addSprings[dimension_ - 1][static_cast<int>(run.damping)](run.arrays(), x, v, f);
  }
}

bool SpringGroups::usesVelocity() const {
  return std::any_of(runs_.begin(), runs_.end(), [](const SpringRun& run) { return run.damping != Damping::None; });
}

}  // namespace muelle::engine::kernels
