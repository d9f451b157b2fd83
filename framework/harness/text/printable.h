#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// Untrusted text made safe for a terminal: control characters (but for newline and tab), bytes that are not UTF-8,
/// and the marks that turn the direction of text become visible escapes such as a backslash, x and 1b.
std::string printable(std::string_view text);

/// The first `lines` lines of the text and at most `bytes` bytes, with a last line that says what was cut.
std::string cutText(std::string_view text, int lines, std::size_t bytes);

/// `prefix` before every line.
std::string indented(std::string_view text, std::string_view prefix);

}  // namespace muelle
