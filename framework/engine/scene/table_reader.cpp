#include "engine/scene/table_reader.h"

#include "harness/text/nearest.h"
#include "harness/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::engine {

namespace {

std::string list(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

/// "; did you mean 'k'?" or else all that is known.
std::string guess(const std::string& word, const std::vector<std::string>& names) {
  const std::string near = didYouMean(word, names);
  return near.empty() ? "; known are " + list(names) : near;
}

}  // namespace

TableReader::TableReader(const Value& table, std::string file, std::string what, Space space)
    : table_(table), file_(std::move(file)), what_(std::move(what)), space_(space) {}

void TableReader::failAt(int line, const std::string& complaint) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file_, line, complaint));
}

void TableReader::fail(const std::string& key, const std::string& complaint) const {
  const Value* value = table_.find(key);
  failAt(value != nullptr ? value->line : table_.line, fmt::format("key '{}': {}", key, complaint));
}

void TableReader::failHere(const std::string& complaint) const {
  failAt(table_.line, fmt::format("{}: {}", what_, complaint));
}

void TableReader::failType(const Value& value, const std::string& key, const std::string& expected) const {
  failAt(value.line, fmt::format("key '{}': expected {}, found {}", key, expected, value.kindName()));
}

void TableReader::checkKeys(const Keys& known, const Keys& required) const {
  for (const auto& [key, value] : table_.table) {
    if (std::ranges::find(known, key) != known.end()) continue;
    failAt(value.line, fmt::format("key '{}': unknown{}", printable(key), guess(key, known)));
  }
  for (const std::string& key : required) {
    if (!has(key)) failAt(table_.line, fmt::format("key '{}': missing in {}", key, what_));
  }
}

std::string TableReader::oneKeyOf(const Keys& keys, bool required) const {
  std::string found;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (!found.empty()) fail(key, fmt::format("goes not together with '{}': give one of {}", found, list(keys)));
    found = key;
  }
  if (required && found.empty()) failHere(fmt::format("one of the keys {} is needed", list(keys)));
  return found;
}

const Value& TableReader::get(const std::string& key) const {
  const Value* value = table_.find(key);
  if (value == nullptr) failAt(table_.line, fmt::format("key '{}': missing in {}", key, what_));
  return *value;
}

std::string TableReader::text(const std::string& key) const {
  const Value& value = get(key);
  if (value.kind != Value::Kind::Text) failType(value, key, "a text in quotes");
  if (value.text.find_first_not_of(" \t") == std::string::npos) fail(key, "is empty");
  const auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  if (std::ranges::any_of(value.text, isControl)) fail(key, "must be one line without control characters");
  return value.text;
}

std::string TableReader::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::string TableReader::choice(const std::string& key, const Keys& names) const {
  const std::string word = text(key);
  if (std::ranges::find(names, word) != names.end()) return word;
  fail(key, fmt::format("'{}' is unknown{}", printable(word), guess(word, names)));
}

bool TableReader::flag(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const Value& value = get(key);
  if (value.kind != Value::Kind::Flag) failType(value, key, "true or false");
  return value.flag;
}

int TableReader::integer(const std::string& key, int least, int most) const {
  const Value& value = get(key);
  if (value.kind != Value::Kind::Integer) failType(value, key, "an integer");
  if (value.integer < least || value.integer > most) {
    fail(key, fmt::format("{} does not lie between {} and {}", value.integer, least, most));
  }
  return static_cast<int>(value.integer);
}

double TableReader::numberOf(const Value& value, const std::string& key, bool allowInfinite) const {
  if (value.kind != Value::Kind::Integer && value.kind != Value::Kind::Number) failType(value, key, "a number");
  if (std::isnan(value.number)) failAt(value.line, fmt::format("key '{}': is not a number", key));
  if (!allowInfinite && std::isinf(value.number)) failAt(value.line, fmt::format("key '{}': must be finite", key));
  return value.number;
}

double TableReader::number(const std::string& key) const { return numberOf(get(key), key); }

double TableReader::positive(const std::string& key) const {
  const double value = number(key);
  if (value <= 0.0) fail(key, fmt::format("is {}; it must be positive", value));
  return value;
}

double TableReader::notNegative(const std::string& key) const {
  const double value = number(key);
  if (value < 0.0) fail(key, fmt::format("is {}; it must not be negative", value));
  return value;
}

double TableReader::number(const std::string& key, double otherwise) const {
  return has(key) ? number(key) : otherwise;
}
double TableReader::positive(const std::string& key, double otherwise) const {
  return has(key) ? positive(key) : otherwise;
}
double TableReader::notNegative(const std::string& key, double otherwise) const {
  return has(key) ? notNegative(key) : otherwise;
}

Vec3 TableReader::vectorOf(const Value& value, const std::string& key, bool allowInfinite) const {
  const std::array<int, 3> axes =
      space_.dimension == 2 ? std::array<int, 3>{space_.plane[0], space_.plane[1], 0} : std::array<int, 3>{0, 1, 2};
  Vec3 result = Vec3::Zero();
  if (space_.dimension == 1 && value.kind != Value::Kind::List) {
    result[0] = numberOf(value, key, allowInfinite);
    return result;
  }
  const auto expected =
      space_.dimension == 1 ? std::string("a number") : fmt::format("a list of {} numbers", space_.dimension);
  if (value.kind != Value::Kind::List) failType(value, key, expected);
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
  const Value& value = get(key);
  if (value.kind != Value::Kind::List || value.list.size() != 2) failType(value, key, "two times, [t0, t1]");
  const double from = numberOf(value.list[0], key);
  const double to = numberOf(value.list[1], key);
  if (!(from < to) || from < 0.0) fail(key, fmt::format("[{}, {}] is no interval 0 <= t0 < t1", from, to));
  return {from, to};
}

std::pair<Vec3, Vec3> TableReader::corners(const std::string& key) const {
  const Value& value = get(key);
  if (value.kind != Value::Kind::List || value.list.size() != 2) failType(value, key, "two corners, [least, greatest]");
  const Vec3 least = vectorOf(value.list[0], key, true);
  const Vec3 most = vectorOf(value.list[1], key, true);
  if ((least.array() > most.array()).any()) fail(key, "the first corner must not lie above the second");
  return {least, most};
}

std::vector<int> TableReader::integers(const std::string& key, int count, int least, int most) const {
  const Value& value = get(key);
  const std::string expected = count > 0 ? fmt::format("a list of {} integers", count) : "a list of integers";
  if (value.kind != Value::Kind::List) failType(value, key, expected);
  if (value.list.empty() || (count > 0 && value.list.size() != static_cast<std::size_t>(count))) {
    failAt(value.line, fmt::format("key '{}': expected {}, found {}", key, expected, value.list.size()));
  }
  std::vector<int> result;
  for (const Value& element : value.list) {
    if (element.kind != Value::Kind::Integer) failType(element, key, expected);
    if (element.integer < least || element.integer > most) {
      failAt(element.line,
             fmt::format("key '{}': {} does not lie between {} and {}", key, element.integer, least, most));
    }
    result.push_back(static_cast<int>(element.integer));
  }
  return result;
}

std::vector<TableReader> TableReader::tables(const std::string& key) const {
  std::vector<TableReader> result;
  const Value* value = table_.find(key);
  if (value == nullptr) return result;
  const std::string what = fmt::format("[[{}]]", key);
  if (value->kind != Value::Kind::List) failType(*value, key, "tables, each begun by " + what);
  for (const Value& element : value->list) {
    if (element.kind != Value::Kind::Table) failType(element, key, "tables, each begun by " + what);
    result.emplace_back(element, file_, what, space_);
  }
  return result;
}

std::optional<TableReader> TableReader::table(const std::string& key) const {
  const Value* value = table_.find(key);
  if (value == nullptr) return std::nullopt;
  const std::string what = fmt::format("[{}]", key);
  if (value->kind != Value::Kind::Table) failType(*value, key, "a table, begun by " + what);
  return TableReader(*value, file_, what, space_);
}

}  // namespace muelle::engine
