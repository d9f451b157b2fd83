#pragma once
#include "base/toml/value.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace muelle {

/// One table of a TOML file: hands out its values checked, and gives every complaint its file, line and key. All
/// functions throw std::runtime_error "FILE:LINE: key 'KEY': what is wrong". The value it reads must outlive it.
class TomlTable {
 public:
  using Keys = std::vector<std::string>;

  /// \param file as messages name it   \param what names the table in messages about missing keys: "[[node]]"
  TomlTable(const TomlValue& table, std::string file, std::string what);

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
  /// A list of different texts, each of which must please `isGood`; empty when the key is absent.
  /// \param expected completes "'x' is not ...": "a plain file name"
  std::vector<std::string> texts(const std::string& key, const std::function<bool(const std::string&)>& isGood,
                                 const std::string& expected) const;
  bool flag(const std::string& key, bool otherwise) const;
  int integer(const std::string& key, int least, int most) const;
  int integer(const std::string& key, int least, int most, int otherwise) const;
  /// Integers of a list between `least` and `most`; a given `count` must be met (0: any, at least one).
  std::vector<int> integers(const std::string& key, int count, int least, int most) const;

  double number(const std::string& key) const;
  double positive(const std::string& key) const;
  double notNegative(const std::string& key) const;
  double number(const std::string& key, double otherwise) const;
  double positive(const std::string& key, double otherwise) const;
  double notNegative(const std::string& key, double otherwise) const;

  /// The tables of [[key]], in the order of the file.
  std::vector<TomlTable> tables(const std::string& key) const;
  /// The table [key]; nothing when absent.
  std::optional<TomlTable> table(const std::string& key) const;

  int line() const { return table_.line; }
  [[noreturn]] void fail(const std::string& key, const std::string& complaint) const;
  [[noreturn]] void failHere(const std::string& complaint) const;

 protected:
  const TomlValue& value() const { return table_; }
  const std::string& file() const { return file_; }
  const TomlValue& get(const std::string& key) const;
  [[noreturn]] void failAt(int line, const std::string& complaint) const;
  [[noreturn]] void failType(const TomlValue& value, const std::string& key, const std::string& expected) const;
  double numberOf(const TomlValue& value, const std::string& key, bool allowInfinite = false) const;

 private:
  std::string textOf(const TomlValue& value, const std::string& key) const;

  const TomlValue& table_;
  std::string file_;
  std::string what_;
};

}  // namespace muelle
