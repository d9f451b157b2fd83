#pragma once
#include <string>

/// Colours and weights of a terminal, as the codes of its escape sequences (ECMA-48, SGR).
namespace muelle::grader::paint {

inline constexpr const char* bold = "1";
inline constexpr const char* dim = "2";
inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* yellow = "33";
inline constexpr const char* none = "";

/// The text in the colour of that code; as it is without a code.
inline std::string painted(const std::string& text, const std::string& code) {
  return code.empty() ? text : "\x1b[" + code + "m" + text + "\x1b[0m";
}

}  // namespace muelle::grader::paint
