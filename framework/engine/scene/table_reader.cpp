#include "engine/scene/table_reader.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::engine {

TableReader::TableReader(const TomlValue& table, std::string file, std::string what, Space space)
    : TomlTable(table, std::move(file), std::move(what)), space_(space) {}

TableReader::TableReader(const TomlTable& table, Space space) : TomlTable(table), space_(space) {}

Vec3 TableReader::vectorOf(const TomlValue& value, const std::string& key, bool allowInfinite) const {
  const std::array<int, 3> axes =
      space_.dimension == 2 ? std::array<int, 3>{space_.plane[0], space_.plane[1], 0} : std::array<int, 3>{0, 1, 2};
  Vec3 result = Vec3::Zero();
  if (space_.dimension == 1 && value.kind != TomlValue::Kind::List) {
    result[0] = numberOf(value, key, allowInfinite);
    return result;
  }
  const auto expected =
      space_.dimension == 1 ? std::string("a number") : fmt::format("a list of {} numbers", space_.dimension);
  if (value.kind != TomlValue::Kind::List) failType(value, key, expected);
  if (value.list.size() != static_cast<std::size_t>(space_.dimension)) {
    failAt(value.line, fmt::format("key '{}': expected {}, found {}", key, expected, value.list.size()));
  }
  for (std::size_t i = 0; i < value.list.size(); ++i) result[axes[i]] = numberOf(value.list[i], key, allowInfinite);
  return result;
}

Vec3 TableReader::vector(const std::string& key) const { return vectorOf(get(key), key); }

Vec3 TableReader::vector(const std::string& key, const Vec3& otherwise) const {
  return has(key) ? vector(key) : otherwise;
}

Vec3 TableReader::sizes(const std::string& key, bool allowInfinite) const {
  Vec3 result = vectorOf(get(key), key, allowInfinite);
  if (space_.dimension == 1) result.tail<2>().setOnes();
  if (space_.dimension == 2) result[3 - space_.plane[0] - space_.plane[1]] = 1.0;
  if ((result.array() <= 0.0).any()) fail(key, "every entry must be positive");
  return result;
}

Vec3 TableReader::direction(const std::string& key) const {
  const Vec3 result = vector(key);
  if (!(result.norm() > 0.0)) fail(key, "has length 0; it gives a direction");
  return result.normalized();
}

Vec3 TableReader::triple(const std::string& key) const {
  TableReader inSpace = *this;
  inSpace.space_.dimension = 3;
  return inSpace.vector(key);
}

std::pair<double, double> TableReader::interval(const std::string& key) const {
  const TomlValue& value = get(key);
  if (value.kind != TomlValue::Kind::List || value.list.size() != 2) failType(value, key, "two times, [t0, t1]");
  const double from = numberOf(value.list[0], key);
  const double to = numberOf(value.list[1], key);
  if (!(from < to) || from < 0.0) fail(key, fmt::format("[{}, {}] is no interval 0 <= t0 < t1", from, to));
  return {from, to};
}

std::pair<Vec3, Vec3> TableReader::corners(const std::string& key) const {
  const TomlValue& value = get(key);
  if (value.kind != TomlValue::Kind::List || value.list.size() != 2)
    failType(value, key, "two corners, [least, greatest]");
  const Vec3 least = vectorOf(value.list[0], key, true);
  const Vec3 most = vectorOf(value.list[1], key, true);
  if ((least.array() > most.array()).any()) fail(key, "the first corner must not lie above the second");
  return {least, most};
}

void TableReader::refuseOtherNames(const std::vector<std::pair<std::string, std::string>>& otherAndOwn) const {
  for (const auto& [other, own] : otherAndOwn) {
    if (has(other)) fail(other, fmt::format("unknown; here it is '{}'", own));
  }
}

std::vector<TableReader> TableReader::tables(const std::string& key) const {
  std::vector<TableReader> result;
  for (const TomlTable& one : TomlTable::tables(key)) result.push_back(TableReader(one, space_));
  return result;
}

std::optional<TableReader> TableReader::table(const std::string& key) const {
  const std::optional<TomlTable> found = TomlTable::table(key);
  if (!found) return std::nullopt;
  return TableReader(*found, space_);
}

}  // namespace muelle::engine
