#pragma once
#include "engine/elements/element.h"

namespace muelle::engine {

/// Three nodes a - b - c that resist bending at b: E = k (theta - theta0)^2 / 2, theta the turning angle at b, 0 when
/// straight; in 2D positive anticlockwise, in 3D never negative. Not in 1D.
struct ModelAngle {
  static constexpr const char* kind = "angle";
  static constexpr int leastDimension = 2;
  static constexpr const char* rest = "rest angle";
  static constexpr std::array ownKeys = {"theta0"};

  std::array<int, 3> nodes = {0, 1, 2};
  double k = 1.0;  ///< [J/rad^2]
  double theta0 = 0.0;
  int part = partOfItsKind;  ///< index into Model::parts

  double restValue() const { return theta0; }
  void check(const std::string& /*item*/) const {}
  static void addTo(Builder& builder, const std::vector<ModelAngle>& angles);
  std::optional<ElementSingularity> singularity(int dimension, const std::vector<Vec3>& places) const;
  void readOwn(const TableReader& table, const Model& model);
};

}  // namespace muelle::engine
