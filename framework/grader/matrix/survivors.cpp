#include "grader/matrix/survivors.h"

#include "harness/text/nearest.h"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::grader {

namespace {

const std::vector<std::string> keys{"line", "mutation", "occurrence", "reason"};

[[noreturn]] void fail(const std::string& shown, toml::source_index line, const std::string& complaint) {
  throw std::runtime_error(fmt::format("{}:{}: {}", shown, line, complaint));
}

std::string requiredText(const toml::table& table, const std::string& key, const std::string& shown) {
  const toml::node* node = table.get(key);
  if (node == nullptr) fail(shown, table.source().begin.line, fmt::format("key '{}': missing", key));
  if (!node->is_string() || (**node->as_string()).empty()) {
    fail(shown, node->source().begin.line, fmt::format("key '{}': expected a text in quotes", key));
  }
  return **node->as_string();
}

int optionalOccurrence(const toml::table& table, const std::string& shown) {
  const toml::node* node = table.get("occurrence");
  if (node == nullptr) return 1;
  const auto value = node->value_exact<std::int64_t>();
  if (!value || *value < 1 || *value > 1000) {
    fail(shown, node->source().begin.line, "key 'occurrence': expected a number from 1");
  }
  return static_cast<int>(*value);
}

Survivor readSurvivor(const toml::table& table, const std::string& shown) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (std::find(keys.begin(), keys.end(), name) == keys.end()) {
      fail(shown, key.source().begin.line, fmt::format("key '{}': unknown{}", name, didYouMean(name, keys)));
    }
  }
  Survivor survivor;
  survivor.lineText = requiredText(table, "line", shown);
  survivor.mutation = requiredText(table, "mutation", shown);
  survivor.occurrence = optionalOccurrence(table, shown);
  survivor.reason = requiredText(table, "reason", shown);
  return survivor;
}

}  // namespace

bool Survivor::matches(const Mutation& other) const {
  return lineText == other.lineText && mutation == other.text() && occurrence == other.occurrence;
}

std::vector<Survivor> readSurvivors(const std::filesystem::path& file, const std::string& shown) {
  if (!std::filesystem::exists(file)) return {};
  toml::table document;
  try {
    document = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    fail(shown, error.source().begin.line, std::string(error.description()));
  }
  std::vector<Survivor> survivors;
  for (const auto& [key, node] : document) {
    const toml::array* array = node.as_array();
    if (key.str() != "survivor" || array == nullptr || !array->is_homogeneous(toml::node_type::table)) {
      fail(shown, key.source().begin.line, fmt::format("key '{}': only [[survivor]] tables stand here", key.str()));
    }
    for (const toml::node& entry : *array) survivors.push_back(readSurvivor(*entry.as_table(), shown));
  }
  return survivors;
}

std::string survivorEntry(const Mutation& mutation) {
  const auto quoted = [](const std::string& text) {
    return text.find('\'') == std::string::npos ? "'" + text + "'" : "\"" + text + "\"";
  };
  std::string entry =
      fmt::format("[[survivor]]\nline = {}\nmutation = {}\n", quoted(mutation.lineText), quoted(mutation.text()));
  if (mutation.occurrence > 1) entry += fmt::format("occurrence = {}\n", mutation.occurrence);
  return entry + "reason = \"\"\n";
}

}  // namespace muelle::grader
