#pragma once
#include "engine/scene/value.h"
#include "harness/types.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace muelle::engine {

/// How the vectors of a scene are written: one number in 1D, [x, z] in a plane, [x, y, z] in space.
struct Space {
  int dimension = 3;
  std::array<int, 2> plane = {0, 2};
};

/// One table of a scene file: hands out its values checked, and gives every complaint its file, line and key. All
/// functions throw std::runtime_error "FILE:LINE: key 'KEY': what is wrong".
class TableReader {
 public:
  using Keys = std::vector<std::string>;

  /// \param what names the table in messages about missing keys: "[[node]]"
  TableReader(const Value& table, std::string file, std::string what, Space space = {});

  /// Every key must be in `known`, every key of `required` must be there. Unknown ones are reported first: a misspelt
  /// key is also a missing one, and the misspelling is what to mend.
  void checkKeys(const Keys& known, const Keys& required) const;
  bool has(const std::string& key) const { return table_.find(key) != nullptr; }
  /// At most one of these keys may be there; with `required` exactly one. Returns it, or "".
  std::string oneKeyOf(const Keys& keys, bool required) const;

  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  /// A text that is one of `names`; the complaint names the nearest.
  std::string choice(const std::string& key, const Keys& names) const;
  bool flag(const std::string& key, bool otherwise) const;
  int integer(const std::string& key, int least, int most) const;

  double number(const std::string& key) const;
  double positive(const std::string& key) const;
  double notNegative(const std::string& key) const;
  double number(const std::string& key, double otherwise) const;
  double positive(const std::string& key, double otherwise) const;
  double notNegative(const std::string& key, double otherwise) const;

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
  /// Integers of a list between `least` and `most`; a given `count` must be met (0: any, at least one).
  std::vector<int> integers(const std::string& key, int count, int least, int most) const;

  /// The tables of [[key]], in the order of the file.
  std::vector<TableReader> tables(const std::string& key) const;
  /// The table [key]; nothing when absent.
  std::optional<TableReader> table(const std::string& key) const;

  int line() const { return table_.line; }
  const Space& space() const { return space_; }
  void setSpace(const Space& space) { space_ = space; }
  [[noreturn]] void fail(const std::string& key, const std::string& complaint) const;
  [[noreturn]] void failHere(const std::string& complaint) const;

 private:
  const Value& get(const std::string& key) const;
  [[noreturn]] void failAt(int line, const std::string& complaint) const;
  [[noreturn]] void failType(const Value& value, const std::string& key, const std::string& expected) const;
  double numberOf(const Value& value, const std::string& key, bool allowInfinite = false) const;
  Vec3 vectorOf(const Value& value, const std::string& key, bool allowInfinite = false) const;

  const Value& table_;
  std::string file_;
  std::string what_;
  Space space_;
};

}  // namespace muelle::engine
