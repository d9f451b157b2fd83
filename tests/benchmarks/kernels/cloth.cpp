#include "cloth.h"

#include "engine/model/numbering.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace muelle::benchmarks {

Cloth makeCloth(int n, bool damped) {
  Cloth cloth;
  cloth.nodes = n * n;
  const auto add = [&](int i, int j, int down, int right) {
    if (i + down >= n || j + right >= n || j + right < 0) return;
    const double L0 = 0.9 / n * std::hypot(down, right);
    cloth.springs.push_back({i * n + j, (i + down) * n + j + right, 1e4, L0, 0.0, damped ? 1.0 : 0.0});
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-0.1, 0.1);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      add(i, j, 1, 0);
      add(i, j, 0, 1);
      add(i, j, 1, 1);
      add(i, j, 1, -1);
      add(i, j, 2, 0);
      add(i, j, 0, 2);
      for (const double grid : {i * 1.0, j * 1.0, 0.0}) {
        cloth.x.push_back((grid + offset(random)) / n);
        cloth.v.push_back(offset(random));
      }
    }
  }
  return cloth;
}

Cloth placed(const Cloth& cloth, const std::vector<int>& place, int count) {
  Cloth result;
  result.nodes = count;
  result.springs = cloth.springs;
  result.x.resize(3 * static_cast<std::size_t>(count));
  result.v.resize(result.x.size());
  for (auto& s : result.springs) {
    s.a = place[static_cast<std::size_t>(s.a)];
    s.b = place[static_cast<std::size_t>(s.b)];
  }
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      result.x[3 * static_cast<std::size_t>(place[i]) + c] = cloth.x[3 * i + c];
      result.v[3 * static_cast<std::size_t>(place[i]) + c] = cloth.v[3 * i + c];
    }
  }
  return result;
}

Cloth shuffled(const Cloth& cloth) {
  std::vector<int> place(static_cast<std::size_t>(cloth.nodes));
  std::iota(place.begin(), place.end(), 0);
  std::mt19937 random(2);
  std::shuffle(place.begin(), place.end(), random);
  Cloth result = placed(cloth, place, cloth.nodes);
  std::shuffle(result.springs.begin(), result.springs.end(), random);
  return result;
}

Cloth renumbered(const Cloth& cloth) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(cloth.springs.size());
  for (const auto& s : cloth.springs) edges.emplace_back(s.a, s.b);
  const std::vector<int> old = engine::reverseCuthillMcKee(cloth.nodes, edges);
  std::vector<int> place(old.size());
  for (std::size_t i = 0; i < old.size(); ++i) place[static_cast<std::size_t>(old[i])] = static_cast<int>(i);
  return placed(cloth, place, cloth.nodes);
}

}  // namespace muelle::benchmarks
