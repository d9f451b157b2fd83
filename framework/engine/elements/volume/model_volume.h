#pragma once
#include "engine/elements/element.h"

namespace muelle::engine {

/// E = k (V - V0)^2 / 2 with the signed volume of the tetrahedron abcd, (b-a) . ((c-a) x (d-a)) / 6. 3D only.
struct ModelVolume {
  static constexpr const char* kind = "volume";
  static constexpr int leastDimension = 3;
  static constexpr const char* rest = "rest volume";
  static constexpr std::array ownKeys = {"V0"};

  std::array<int, 4> nodes = {0, 1, 2, 3};
  double k = 1.0;            ///< [N/m^5]
  double V0 = 1.0;           ///< [m^3]
  int part = partOfItsKind;  ///< index into Model::parts

  /// The volume where its nodes start [m^3].
  double volumeIn(const Model& model) const;

  double restValue() const { return V0; }
  void check(const std::string& /*item*/) const {}
  static void addTo(Builder& builder, const std::vector<ModelVolume>& volumes);
  /// A polynomial has no such place.
  std::optional<ElementSingularity> singularity(int, const std::vector<Vec3>&) const { return std::nullopt; }
  void readOwn(const TableReader& table, const Model& model);
};

}  // namespace muelle::engine
