#include "lab/advise/path_rows.h"

#include "engine/model/axes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

double largestNodeGap(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) {
    double squares = 0.0;
    for (std::size_t c = i; c < i + 3; ++c) squares += (a[c] - b[c]) * (a[c] - b[c]);
    if (!(squares <= largest)) largest = squares;  // a NaN stays
  }
  return std::sqrt(largest);
}

}  // namespace

Vec3 placeOf(const ModelSystem& system, const State& state, int node) {
  const Vec3 moved = system.position(state, node);
  const Model& model = system.model();
  Vec3 place = model.nodes[static_cast<std::size_t>(node)].x;
  for (const int c : axesOf(model)) place[c] = moved[c];
  return place;
}

void PathRows::add(const ModelSystem& system, const State& state) {
  t.push_back(state.t);
  std::vector<double>& positions = x.emplace_back();
  std::vector<double>& velocities = v.emplace_back();
  for (int node = 0; node < system.nodeCount(); ++node) {
    const Vec3 place = placeOf(system, state, node), velocity = system.velocity(state, node);
    positions.insert(positions.end(), place.begin(), place.end());
    velocities.insert(velocities.end(), velocity.begin(), velocity.end());
  }
}

void PathRows::thin() {
  std::size_t kept = 0;
  for (std::size_t i = (t.size() - 1) % 2; i < t.size(); i += 2, ++kept) {
    t[kept] = t[i];
    x[kept] = std::move(x[i]);
    v[kept] = std::move(v[i]);
  }
  t.resize(kept);
  x.resize(kept);
  v.resize(kept);
}

MotionSize distanceOf(const PathRows& a, std::size_t i, const PathRows& b, std::size_t j) {
  return {largestNodeGap(a.x[i], b.x[j]), largestNodeGap(a.v[i], b.v[j])};
}

MotionSize distanceOf(const PathRows& a, const PathRows& b) {
  MotionSize apart;
  std::size_t common = 0;
  for (std::size_t i = 0, j = 0; i < a.size(); ++i) {
    const double slack = 1e-11 * std::abs(a.t.back());
    while (j < b.size() && b.t[j] < a.t[i] - slack) ++j;
    if (j == b.size()) break;
    if (b.t[j] > a.t[i] + slack) continue;
    ++common;
    apart.include(distanceOf(a, i, b, j));
  }
  if (common == 0) throw std::logic_error("two runs have no time in common");
  return apart;
}

void MotionSize::include(const MotionSize& other) {
  if (!(other.position <= position)) position = other.position;  // a NaN stays
  if (!(other.velocity <= velocity)) velocity = other.velocity;
}

double errorIn(const MotionSize& distance, const MotionSize& motion) {
  return std::max(distance.position / motion.position, distance.velocity / motion.velocity);
}

}  // namespace muelle::lab
