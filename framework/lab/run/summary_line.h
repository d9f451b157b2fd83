#pragma once
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace muelle::lab {

/// A line of what a command says of a scene: the name in a column of its own, then the text.
inline std::string summaryLine(std::string_view name, std::string_view text) {
  return fmt::format("  {:<11} {}\n", name, text);
}

}  // namespace muelle::lab
