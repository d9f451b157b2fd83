#include "engine/model/require.h"

#include "base/text/count.h"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace muelle::engine {

void reject(const std::string& item, const std::string& fault) { throw std::invalid_argument(item + ": " + fault); }

bool isDenormal(double value) { return value != 0.0 && std::abs(value) < std::numeric_limits<double>::min(); }

void requireFinite(const std::string& item, const char* what, double value) {
  if (!std::isfinite(value)) reject(item, fmt::format("{} is {}; it must be finite", what, value));
}

void requireFinite(const std::string& item, const char* what, const Vec3& value) {
  for (const double component : value) {
    if (!std::isfinite(component)) {
      reject(item, fmt::format("{} is ({}, {}, {}); it must be finite", what, value[0], value[1], value[2]));
    }
  }
}

void requireNotNegative(const std::string& item, const char* what, double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    reject(item, fmt::format("{} is {}; it must be finite and not negative", what, value));
  }
}

void requireStiffness(const std::string& item, const char* what, double value) {
  requireNotNegative(item, what, value);
  if (isDenormal(value)) {
    reject(item, fmt::format("{} is {}, below the smallest normal number; write 0 for none", what, value));
  }
}

void requireUnit(const std::string& item, const char* what, const Vec3& value) {
  requireFinite(item, what, value);
  if (!(std::abs(value.norm() - 1.0) < 1e-9)) {
    reject(item, fmt::format("{} is ({}, {}, {}), of length {}; it must have length 1", what, value[0], value[1],
                             value[2], value.norm()));
  }
}

void requireNodes(const Model& model, const std::string& item, std::span<const int> nodes) {
  const int count = static_cast<int>(model.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] < 0 || nodes[i] >= count) {
      reject(item, fmt::format("there is no node {}; nodes are 0 to {}", nodes[i], count - 1));
    }
  }
}

void requirePart(const Model& model, const std::string& item, int part) {
  if (part == partOfItsKind || (part >= 0 && part < std::ssize(model.parts))) return;
  reject(item, fmt::format("there is no part {}; the model has {}", part, counted(std::ssize(model.parts), "part")));
}

void requireDifferent(const std::string& item, std::span<const int> nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (nodes[i] == nodes[j]) reject(item, fmt::format("uses node {} twice", nodes[i]));
    }
  }
}

}  // namespace muelle::engine
