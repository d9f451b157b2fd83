#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

struct TomlEntry;

/// A TOML file as plain data, each value with the line on which it stands: only one source reads toml++.
struct TomlValue {
  enum class Kind { Text, Integer, Number, Flag, List, Table, Other };
  Kind kind = Kind::Table;
  int line = 1;
  std::string text;
  double number = 0.0;  ///< of Integer and Number
  std::int64_t integer = 0;
  bool flag = false;
  std::vector<TomlValue> list;
  std::vector<TomlEntry> table;  ///< in the order of the file

  /// The value of that key of a table; null when there is none.
  const TomlValue* find(const std::string& key) const;
  /// "a number", "a list": for messages.
  std::string kindName() const;
};

/// A key with its value.
struct TomlEntry {
  std::string first;  ///< the key
  TomlValue second;
};

/// "folder/file.toml": how messages name a file of the course, whose folders are known.
std::string shownPath(const std::filesystem::path& file);

/// Reads a TOML file. Throws std::runtime_error "NAME:LINE: what is wrong"; files above 1 MiB are refused.
TomlValue readToml(const std::filesystem::path& file, const std::string& name);

}  // namespace muelle
