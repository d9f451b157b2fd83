#include "engine/kernels/grid_search.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace muelle::engine::kernels {

namespace {

constexpr std::size_t mostRuns = 64;

/// A spring as the search sees it; layer counts springs between the same nodes.
struct Stretch {
  std::size_t stride;
  int form, layer;
  std::size_t begin;
  const SpringData* spring;
  auto runKey() const { return std::tuple(stride, form, layer); }
};

std::vector<Stretch> sortedStretches(int dimension, std::span<const SpringData> springs) {
  std::vector<Stretch> all;
  all.reserve(springs.size());
  for (const SpringData& s : springs) {
    if (s.a == s.b) continue;
    const auto low = static_cast<std::size_t>(std::min(s.a, s.b)), high = static_cast<std::size_t>(std::max(s.a, s.b));
    all.push_back({high - low, static_cast<int>(dampingOf(s, dimension)), 0, low, &s});
  }
  const auto place = [](const Stretch& s) { return std::tuple(s.stride, s.form, s.begin, s.spring); };
  std::sort(all.begin(), all.end(), [&](const Stretch& a, const Stretch& b) { return place(a) < place(b); });
  const auto nodesOf = [](const Stretch& s) { return std::tuple(s.stride, s.form, s.begin); };
  bool repeated = false;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (nodesOf(all[i]) != nodesOf(all[i - 1])) continue;
    all[i].layer = all[i - 1].layer + 1;
    repeated = true;
  }
  if (repeated) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Stretch& a, const Stretch& b) { return a.runKey() < b.runKey(); });
  }
  return all;
}

bool isAbout(double value, double first, double part) { return std::abs(value - first) <= part * std::abs(first); }

bool areAlike(const SpringData& s, const SpringData& first, double part) {
  return isAbout(s.k, first.k, part) && isAbout(s.L0, first.L0, part) && isAbout(s.dRelative, first.dRelative, part) &&
         isAbout(s.dProjected, first.dProjected, part);
}

void setMaterial(GridRun& run, std::size_t at, const SpringData& s, int dimension) {
  run.k[at] = s.k;
  run.L0[at] = s.L0;
  if (!run.dRelative.empty()) run.dRelative[at] = relativeDampingOf(s, dimension);
  if (!run.dProjected.empty()) run.dProjected[at] = s.dProjected;
}

GridRun makeRun(int dimension, std::span<const Stretch> stretches, double sameMaterial) {
  GridRun run;
  const Stretch& first = stretches.front();
  run.stride = first.stride;
  run.damping = static_cast<Damping>(first.form);
  run.begin = first.begin;
  run.end = stretches.back().begin + 1;
  run.isConstant = std::all_of(stretches.begin(), stretches.end(),
                               [&](const Stretch& s) { return areAlike(*s.spring, *first.spring, sameMaterial); });
  const std::size_t entries = run.isConstant ? 1 : run.end - run.begin;
  run.k.resize(entries);
  run.L0.resize(entries);
  if (run.damping == Damping::Relative || run.damping == Damping::Both) run.dRelative.resize(entries);
  if (run.damping == Damping::Projected || run.damping == Damping::Both) run.dProjected.resize(entries);
  std::size_t next = run.begin;
  for (const Stretch& s : stretches) {
    for (; next < s.begin; ++next) run.gaps.push_back(next);
    ++next;
    if (!run.isConstant || &s == &first)
      setMaterial(run, run.isConstant ? 0 : s.begin - run.begin, *s.spring, dimension);
  }
  return run;
}

/// Whether it pays to go through all of a run: it is filled enough, and not a handful among very many nodes.
bool isWorthIt(std::span<const Stretch> stretches, std::size_t nodes) {
  const std::size_t length = stretches.back().begin - stretches.front().begin + 1;
  return 3 * stretches.size() >= length && 200 * stretches.size() >= nodes;
}

void refuseUnlessGrid(GridSearch& found, std::size_t springs, std::size_t strides) {
  std::size_t gaps = 0;
  for (const GridRun& run : found.runs) gaps += run.gaps.size();
  if (20 * found.loose.size() > springs) {
    found.refusal =
        fmt::format("{} of {} springs are in no run of equal differences of node numbers, of which there are {}",
                    found.loose.size(), springs, strides);
  } else if (gaps > springs) {
    found.refusal = fmt::format("runs of equal differences of node numbers have {} gaps for {} springs", gaps, springs);
  } else if (found.runs.size() > mostRuns) {
    found.refusal =
        fmt::format("{} runs of equal differences of node numbers; at most {}", found.runs.size(), mostRuns);
  }
}

}  // namespace

GridSearch findRuns(int dimension, std::size_t nodes, std::span<const SpringData> springs, double sameMaterial) {
  GridSearch found;
  const std::vector<Stretch> all = sortedStretches(dimension, springs);
  std::size_t strides = 0;
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    if (i == 0 || all[i].stride != all[i - 1].stride) ++strides;
    while (end < all.size() && all[end].runKey() == all[i].runKey()) ++end;
    const std::span<const Stretch> stretches(all.data() + i, end - i);
    if (isWorthIt(stretches, nodes)) {
      found.runs.push_back(makeRun(dimension, stretches, sameMaterial));
    } else {
      for (const Stretch& s : stretches) found.loose.push_back(*s.spring);
    }
  }
  refuseUnlessGrid(found, all.size(), strides);
  return found;
}

}  // namespace muelle::engine::kernels
