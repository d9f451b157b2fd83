#include "base/toml/table.h"

#include "base/text/lists.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle {

TomlTable::TomlTable(const TomlValue& table, std::string file, std::string what)
    : table_(table), file_(std::move(file)), what_(std::move(what)) {}

void TomlTable::failAt(int line, const std::string& complaint) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file_, line, complaint));
}

void TomlTable::fail(const std::string& key, const std::string& complaint) const {
  const TomlValue* value = table_.find(key);
  failAt(value != nullptr ? value->line : table_.line, fmt::format("key '{}': {}", key, complaint));
}

void TomlTable::failHere(const std::string& complaint) const {
  failAt(table_.line, fmt::format("{}: {}", what_, complaint));
}

void TomlTable::failType(const TomlValue& value, const std::string& key, const std::string& expected) const {
  failAt(value.line, fmt::format("key '{}': expected {}, found {}", key, expected, value.kindName()));
}

void TomlTable::checkKeys(const Keys& known, const Keys& required) const {
  for (const auto& [key, value] : table_.table) {
    if (std::ranges::find(known, key) != known.end()) continue;
    failAt(value.line, fmt::format("key '{}': unknown{}", printableLine(key), suggestion(key, known)));
  }
  for (const std::string& key : required) {
    if (!has(key)) failAt(table_.line, fmt::format("key '{}': missing in {}", key, what_));
  }
}

std::string TomlTable::oneKeyOf(const Keys& keys, bool required) const {
  std::string found;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (!found.empty())
      fail(key, fmt::format("goes not together with '{}': give one of {}", found, joined(keys, ", ")));
    found = key;
  }
  if (required && found.empty()) failHere(fmt::format("one of the keys {} is needed", joined(keys, ", ")));
  return found;
}

const TomlValue& TomlTable::get(const std::string& key) const {
  const TomlValue* value = table_.find(key);
  if (value == nullptr) failAt(table_.line, fmt::format("key '{}': missing in {}", key, what_));
  return *value;
}

std::string TomlTable::textOf(const TomlValue& value, const std::string& key) const {
  if (value.text.find_first_not_of(" \t") == std::string::npos)
    failAt(value.line, fmt::format("key '{}': is empty", key));
  const auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  if (std::ranges::any_of(value.text, isControl)) {
    failAt(value.line, fmt::format("key '{}': must be one line without control characters", key));
  }
  return value.text;
}

std::string TomlTable::text(const std::string& key) const {
  const TomlValue& value = get(key);
  if (value.kind != TomlValue::Kind::Text) failType(value, key, "a text in quotes");
  return textOf(value, key);
}

std::string TomlTable::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::string TomlTable::choice(const std::string& key, const Keys& names) const {
  const std::string word = text(key);
  if (std::ranges::find(names, word) != names.end()) return word;
  fail(key, fmt::format("'{}' is unknown{}", printableLine(word), suggestion(word, names)));
}

std::vector<std::string> TomlTable::texts(const std::string& key, const std::function<bool(const std::string&)>& isGood,
                                          const std::string& expected) const {
  const TomlValue* value = table_.find(key);
  if (value == nullptr) return {};
  const std::string aList = "a list of texts, [\"...\", \"...\"]";
  if (value->kind != TomlValue::Kind::List) failType(*value, key, aList);
  std::vector<std::string> result;
  const auto complain = [&](const TomlValue& element, const char* complaint, const std::string& more) {
    failAt(element.line, fmt::format("key '{}': '{}' {}{}", key, printableLine(element.text), complaint, more));
  };
  for (const TomlValue& element : value->list) {
    if (element.kind != TomlValue::Kind::Text) failType(element, key, aList);
    if (!isGood(element.text)) complain(element, "is not ", expected);
    if (std::ranges::find(result, element.text) != result.end()) complain(element, "stands twice", "");
    result.push_back(element.text);
  }
  if (result.empty()) fail(key, "is empty");
  return result;
}

bool TomlTable::flag(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const TomlValue& value = get(key);
  if (value.kind != TomlValue::Kind::Flag) failType(value, key, "true or false");
  return value.flag;
}

int TomlTable::integer(const std::string& key, int least, int most) const {
  const TomlValue& value = get(key);
  if (value.kind != TomlValue::Kind::Integer) failType(value, key, "an integer");
  if (value.integer < least || value.integer > most) {
    fail(key, fmt::format("{} does not lie between {} and {}", value.integer, least, most));
  }
  return static_cast<int>(value.integer);
}

int TomlTable::integer(const std::string& key, int least, int most, int otherwise) const {
  return has(key) ? integer(key, least, most) : otherwise;
}

double TomlTable::numberOf(const TomlValue& value, const std::string& key, bool allowInfinite) const {
  if (value.kind != TomlValue::Kind::Integer && value.kind != TomlValue::Kind::Number) failType(value, key, "a number");
  if (std::isnan(value.number)) failAt(value.line, fmt::format("key '{}': is not a number", key));
  if (!allowInfinite && std::isinf(value.number)) failAt(value.line, fmt::format("key '{}': must be finite", key));
  return value.number;
}

double TomlTable::number(const std::string& key) const { return numberOf(get(key), key); }

double TomlTable::positive(const std::string& key) const {
  const double value = number(key);
  if (value <= 0.0) fail(key, fmt::format("is {}; it must be positive", value));
  return value;
}

double TomlTable::notNegative(const std::string& key) const {
  const double value = number(key);
  if (value < 0.0) fail(key, fmt::format("is {}; it must not be negative", value));
  return value;
}

double TomlTable::number(const std::string& key, double otherwise) const { return has(key) ? number(key) : otherwise; }
double TomlTable::positive(const std::string& key, double otherwise) const {
  return has(key) ? positive(key) : otherwise;
}
double TomlTable::notNegative(const std::string& key, double otherwise) const {
  return has(key) ? notNegative(key) : otherwise;
}

std::vector<int> TomlTable::integers(const std::string& key, int count, int least, int most) const {
  const TomlValue& value = get(key);
  const std::string expected = count > 0 ? fmt::format("a list of {} integers", count) : "a list of integers";
  if (value.kind != TomlValue::Kind::List) failType(value, key, expected);
  if (value.list.empty() || (count > 0 && value.list.size() != static_cast<std::size_t>(count))) {
    failAt(value.line, fmt::format("key '{}': expected {}, found {}", key, expected, value.list.size()));
  }
  std::vector<int> result;
  for (const TomlValue& element : value.list) {
    if (element.kind != TomlValue::Kind::Integer) failType(element, key, expected);
    if (element.integer < least || element.integer > most) {
      failAt(element.line,
             fmt::format("key '{}': {} does not lie between {} and {}", key, element.integer, least, most));
    }
    result.push_back(static_cast<int>(element.integer));
  }
  return result;
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  std::vector<TomlTable> result;
  const TomlValue* list = table_.find(key);
  if (list == nullptr) return result;
  const std::string what = fmt::format("[[{}]]", key);
  if (list->kind != TomlValue::Kind::List) failType(*list, key, "tables, each begun by " + what);
  for (const TomlValue& element : list->list) {
    if (element.kind != TomlValue::Kind::Table) failType(element, key, "tables, each begun by " + what);
    result.emplace_back(element, file_, what);
  }
  return result;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) const {
  const TomlValue* found = table_.find(key);
  if (found == nullptr) return std::nullopt;
  const std::string what = fmt::format("[{}]", key);
  if (found->kind != TomlValue::Kind::Table) failType(*found, key, "a table, begun by " + what);
  return TomlTable(*found, file_, what);
}

}  // namespace muelle
