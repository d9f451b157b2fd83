#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

#include <numbers>

namespace muelle::hard_cases {

Model cloth(double k, double d) {
  constexpr int side = 10;
  Model model;
  model.gravity = Vec3(0, 0, -g);
  const auto index = [](int i, int j) { return side * j + i; };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) model.nodes.push_back(at(Vec3(0.1 * i, 0.1 * j, 0), 0.001));
  }
  model.nodes[0].pinned = model.nodes[9].pinned = true;
  const auto join = [&](int a, int b, double L0) {
    model.springs.push_back({.a = a, .b = b, .k = k, .L0 = L0, .dProjected = d});
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      if (i + 1 < side) join(index(i, j), index(i + 1, j), 0.1);
      if (j + 1 < side) join(index(i, j), index(i, j + 1), 0.1);
      if (i + 1 == side || j + 1 == side) continue;
      join(index(i, j), index(i + 1, j + 1), 0.1 * std::numbers::sqrt2);
      join(index(i + 1, j), index(i, j + 1), 0.1 * std::numbers::sqrt2);
    }
  }
  return model;
}

}  // namespace muelle::hard_cases
