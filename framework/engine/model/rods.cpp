#include "engine/model/rods.h"

#include <fmt/format.h>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

constexpr double least = 1e-9;  ///< of a rod's length, of its ends' speeds, of a row of unit size

[[noreturn]] void refuseRod(std::size_t spring, const std::string& why) {
  throw std::invalid_argument(fmt::format("spring {}: {}", spring, why));
}

const ModelNode& nodeOf(const Model& model, int i) { return model.nodes[static_cast<std::size_t>(i)]; }

void checkRod(const Model& model, std::size_t i) {
  const ModelSpring& rod = model.springs[i];
  if (rod.unilateral || rod.dRelative > 0.0 || rod.dProjected > 0.0 || rod.dampingRatio > 0.0) {
    refuseRod(i, "a rod is neither damped nor one-sided");
  }
  const ModelNode &a = nodeOf(model, rod.a), &b = nodeOf(model, rod.b);
  for (const int end : {rod.a, rod.b}) {
    if (nodeOf(model, end).motion < 0) continue;
    refuseRod(i, fmt::format("a rod cannot be held by node {}, which is moved; take a stiff spring", end));
  }
  const double length = (a.x - b.x).norm();
  if (!(rod.L0 > 0.0) || !(std::abs(length - rod.L0) <= least * rod.L0)) {
    refuseRod(i, fmt::format("a rod of {:.9g} m between nodes {} and {}, which are {:.9g} m apart; place them at its "
                             "length, or leave L0 out",
                             rod.L0, rod.a, rod.b, length));
  }
  const Vec3 va = isFree(a) ? a.v : Vec3::Zero(), vb = isFree(b) ? b.v : Vec3::Zero();
  const double rate = (va - vb).dot(a.x - b.x) / length;
  if (std::abs(rate) > least * (va.norm() + vb.norm())) {
    refuseRod(i, fmt::format("a rod whose ends, nodes {} and {}, start at {:.3g} m/s along it; it cannot stretch",
                             rod.a, rod.b, rate));
  }
}

/// Rows of the derivative of the lengths by the free nodes' positions, reduced one by one by those before: what is left
/// of a redundant one is round-off.
class Elimination {
 public:
  /// Whether the row is independent of those added before; it then joins them.
  bool add(std::map<int, double> row) {
    for (const auto& [column, pivot] : rows_) {
      const auto found = row.find(column);
      if (found == row.end()) continue;
      const double factor = found->second;
      for (const auto& [c, value] : pivot) row[c] -= factor * value;
      row.erase(column);
    }
    auto largest = row.end();
    for (auto entry = row.begin(); entry != row.end(); ++entry) {
      if (largest == row.end() || std::abs(entry->second) > std::abs(largest->second)) largest = entry;
    }
    if (largest == row.end() || std::abs(largest->second) < least) return false;
    const int column = largest->first;
    const double size = largest->second;
    for (auto& [c, value] : row) value /= size;
    rows_.emplace_back(column, std::move(row));
    return true;
  }

 private:
  std::vector<std::pair<int, std::map<int, double>>> rows_;  ///< pivot's column, row with 1 there
};

std::map<int, double> derivative(const Model& model, const ModelSpring& rod) {
  const Vec3 n = (nodeOf(model, rod.a).x - nodeOf(model, rod.b).x).normalized();
  std::map<int, double> row;
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis] == 0.0) continue;
    if (isFree(nodeOf(model, rod.a))) row[3 * rod.a + axis] = n[axis];
    if (isFree(nodeOf(model, rod.b))) row[3 * rod.b + axis] = -n[axis];
  }
  return row;
}

}  // namespace

void checkRods(const Model& model) {
  constexpr int mostNamed = 5;
  Elimination elimination;
  std::string names;
  int redundant = 0;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& rod = model.springs[i];
    if (!rod.rod) continue;
    checkRod(model, i);
    if (elimination.add(derivative(model, rod)) || ++redundant > mostNamed) continue;
    names += fmt::format("{}spring {} (nodes {} and {})", names.empty() ? "" : ", ", i, rod.a, rod.b);
  }
  if (redundant == 0) return;
  throw std::invalid_argument(
      fmt::format("{}{}: redundant {}: pins and the rods before hold the length already, at the start, and the force "
                  "would be undetermined; leave {} out, or give {} a stiffness k",
                  names, redundant > mostNamed ? fmt::format(" and {} more", redundant - mostNamed) : "",
                  redundant == 1 ? "rod" : "rods", redundant == 1 ? "it" : "them", redundant == 1 ? "it" : "them"));
}

}  // namespace muelle::engine
