#include "base/toml/value.h"

#include "base/file.h"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <algorithm>
#include <stdexcept>

namespace muelle {

namespace {

constexpr std::uintmax_t largestFile = 1 << 20;

int lineOf(const toml::node& node) { return std::max(1, static_cast<int>(node.source().begin.line)); }

TomlValue convert(const toml::node& node) {
  TomlValue value;
  value.line = lineOf(node);
  value.kind = TomlValue::Kind::Other;
  if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::Text;
    value.text = **text;
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::Integer;
    value.integer = **integer;
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = TomlValue::Kind::Number;
    value.number = **number;
  } else if (const auto* flag = node.as_boolean()) {
    value.kind = TomlValue::Kind::Flag;
    value.flag = **flag;
  } else if (const auto* array = node.as_array()) {
    value.kind = TomlValue::Kind::List;
    for (const toml::node& element : *array) value.list.push_back(convert(element));
  } else if (const auto* table = node.as_table()) {
    value.kind = TomlValue::Kind::Table;
    for (const auto& [key, element] : *table) value.table.push_back({std::string(key.str()), convert(element)});
    std::ranges::stable_sort(value.table, {}, [](const auto& entry) { return entry.second.line; });
  }
  return value;
}

}  // namespace

const TomlValue* TomlValue::find(const std::string& key) const {
  const auto found = std::ranges::find(table, key, &TomlEntry::first);
  return found == table.end() ? nullptr : &found->second;
}

std::string TomlValue::kindName() const {
  switch (kind) {
    case Kind::Text:
      return "a text";
    case Kind::Integer:
      return "an integer";
    case Kind::Number:
      return "a number";
    case Kind::Flag:
      return "true or false";
    case Kind::List:
      return "a list";
    case Kind::Table:
      return "a table";
    case Kind::Other:
      break;
  }
  return "a date or time";
}

std::string shownPath(const std::filesystem::path& file) {
  return (file.parent_path().filename() / file.filename()).string();
}

TomlValue readToml(const std::filesystem::path& file, const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file) && std::filesystem::file_size(file, ignored) > largestFile) {
    throw std::runtime_error(fmt::format("{}: larger than 1 MiB; large data belong in a mesh file", name));
  }
  const std::string text = readFile(file);
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", name, std::max(1u, error.source().begin.line), std::string(error.description())));
  }
}

}  // namespace muelle
