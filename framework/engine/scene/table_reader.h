#pragma once
#include "base/toml/table.h"
#include "harness/types.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace muelle::engine {

/// How the vectors of a scene are written: one number in 1D, [x, z] in a plane, [x, y, z] in space.
struct Space {
  int dimension = 3;
  std::array<int, 2> plane = {0, 2};
};

/// One table of a scene file: what TomlTable reads, and vectors of the scene's space.
class TableReader : public TomlTable {
 public:
  /// \param what names the table in messages about missing keys: "[[node]]"
  TableReader(const TomlValue& table, std::string file, std::string what, Space space = {});

  /// A vector of the scene's space (see Space); components that the scene does not have are 0.
  Vec3 vector(const std::string& key) const;
  Vec3 vector(const std::string& key, const Vec3& otherwise) const;
  /// A vector of lengths, each positive; infinite when `allowInfinite`.
  Vec3 sizes(const std::string& key, bool allowInfinite) const;
  /// A direction: not zero; returned with length 1.
  Vec3 direction(const std::string& key) const;
  /// Always three numbers, whatever the scene's space.
  Vec3 triple(const std::string& key) const;
  /// [t0, t1], ascending.
  std::pair<double, double> interval(const std::string& key) const;
  /// Two vectors [[..], [..]], the first below the second in every component.
  std::pair<Vec3, Vec3> corners(const std::string& key) const;

  /// Refuses keys by a name that they had, or have elsewhere, naming the one that they have here.
  void refuseOtherNames(const std::vector<std::pair<std::string, std::string>>& otherAndOwn) const;

  /// The tables of [[key]], in the order of the file, in the same space.
  std::vector<TableReader> tables(const std::string& key) const;
  /// The table [key]; nothing when absent.
  std::optional<TableReader> table(const std::string& key) const;

  const Space& space() const { return space_; }
  void setSpace(const Space& space) { space_ = space; }

 private:
  TableReader(const TomlTable& table, Space space);
  Vec3 vectorOf(const TomlValue& value, const std::string& key, bool allowInfinite = false) const;

  Space space_;
};

}  // namespace muelle::engine
