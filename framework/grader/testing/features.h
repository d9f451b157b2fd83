#pragma once
#include "grader/testing/argument_items.h"

#include <vector>

namespace muelle::grader {

/// More would separate right from wrong by accident, and fill the records.
inline constexpr std::size_t mostFeatures = 40;

/// A feature with its value in one call.
struct FeatureValue {
  Feature feature;
  double value;
};

/// What a mistake may depend on: numbers, lengths, distances and counts among the arguments of one call.
std::vector<FeatureValue> featuresOf(const std::vector<ArgumentItem>& items);

}  // namespace muelle::grader
