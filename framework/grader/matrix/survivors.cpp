#include "grader/matrix/survivors.h"

#include "base/toml/table.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

Survivor readSurvivor(const TomlTable& table) {
  table.checkKeys({"line", "mutation", "occurrence", "reason"}, {"line", "mutation", "reason"});
  constexpr int mostOccurrences = 1000;
  return {table.text("line"), table.text("mutation"), table.integer("occurrence", 1, mostOccurrences, 1),
          table.text("reason")};
}

}  // namespace

bool Survivor::matches(const Mutation& other) const {
  return lineText == other.lineText && mutation == other.text() && occurrence == other.occurrence;
}

Survivors readSurvivors(const std::filesystem::path& file, const std::string& shown) {
  if (!std::filesystem::exists(file)) return {};
  const TomlValue root = readToml(file, shown);
  const TomlTable document(root, shown, "the list of survivors");
  document.checkKeys({"survivor", "any"}, {});
  Survivors survivors;
  survivors.any = document.text("any", "");
  for (const TomlTable& table : document.tables("survivor")) survivors.listed.push_back(readSurvivor(table));
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
