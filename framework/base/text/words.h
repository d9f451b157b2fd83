#pragma once
#include <string_view>

namespace muelle {

/// Whether `part` stands somewhere in `text`.
inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Whether `c` may stand in the name of a C++ function: an ASCII letter, a digit or an underscore.
inline bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace muelle
