#pragma once
#include <exception>
#include <string>
#include <string_view>

namespace muelle {

/// What an exception says; "" when its what() gives no text at all.
inline std::string_view textOf(const std::exception& error) {
  const char* text = error.what();
  return text == nullptr ? "" : text;
}

/// "threw an exception: no such node", to follow a function's name; on one line and not longer than anybody reads.
/// \param text the exception's; "" for an object that is no std::exception, or that has none
std::string thrownSentence(std::string_view text);

}  // namespace muelle
