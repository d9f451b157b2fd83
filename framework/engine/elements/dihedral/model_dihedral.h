#pragma once
#include "engine/elements/element.h"

namespace muelle::engine {

/// Two triangles (a, b, c) and (b, a, d) with the common edge ab: E = k (theta - theta0)^2 / 2, theta the signed angle
/// between their normals. 3D only.
struct ModelDihedral {
  static constexpr const char* kind = "dihedral";
  static constexpr int leastDimension = 3;
  static constexpr const char* rest = "rest angle";
  static constexpr std::array ownKeys = {"theta0"};

  std::array<int, 4> nodes = {0, 1, 2, 3};
  double k = 1.0;  ///< [J/rad^2]
  double theta0 = 0.0;
  int part = partOfItsKind;  ///< index into Model::parts

  double restValue() const { return theta0; }
  void check(const std::string& /*item*/) const {}
  static void addTo(Builder& builder, const std::vector<ModelDihedral>& dihedrals);
  std::optional<ElementSingularity> singularity(int dimension, const std::vector<Vec3>& places) const;
  void readOwn(const TableReader& table, const Model& model);
};

}  // namespace muelle::engine
