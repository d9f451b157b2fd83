#pragma once
#include "engine/elements/element.h"

namespace muelle::engine {

/// E = k (A - A0)^2 / 2 with the signed area of abc: in 2D positive when anticlockwise. In 3D the area is measured
/// along the unit vector `normal`.
struct ModelArea {
  static constexpr const char* kind = "area";
  static constexpr int leastDimension = 2;
  static constexpr const char* rest = "rest area";
  static constexpr std::array ownKeys = {"A0", "normal"};

  std::array<int, 3> nodes = {0, 1, 2};
  double k = 1.0;               ///< [N/m^3]
  double A0 = 1.0;              ///< [m^2]
  Vec3 normal = Vec3::UnitZ();  ///< 3D only
  int part = partOfItsKind;     ///< index into Model::parts

  /// Of the triangle where its nodes start, in 3D; zero where it has none.
  Vec3 normalIn(const Model& model) const;
  /// The area where its nodes start, as the energy measures it [m^2].
  double areaIn(const Model& model) const;

  double restValue() const { return A0; }
  void check(const std::string& item) const;
  static void addTo(Builder& builder, const std::vector<ModelArea>& areas);
  /// A polynomial has no such place.
  std::optional<ElementSingularity> singularity(int, const std::vector<Vec3>&) const { return std::nullopt; }
  void readOwn(const TableReader& table, const Model& model);
};

}  // namespace muelle::engine
