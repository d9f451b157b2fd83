#pragma once
/// \file
/// Untrusted text made fit to be shown: what a submission names or prints appears as text and does nothing else.

#include <string>
#include <string_view>

namespace muelle {

/// `text` as valid UTF-8 on one line. Whatever would act or hide (control characters, terminal escapes, line breaks,
/// right-to-left marks, zero-width characters, invalid bytes, code points that are no characters) is spelled out:
/// "\x1b", "\n", "\u{202e}". A tab becomes a space.
std::string printableLine(std::string_view text);

/// The same over several lines: "\n" and "\r\n" end lines, a tab is four spaces.
std::string printableText(std::string_view text);

/// `text`, which is printable, cut to `bytes` at a character's boundary, with "..." when something was cut.
std::string cut(const std::string& text, std::size_t bytes);

/// The first `lines` lines of the text and at most `bytes` bytes, with a last line that says what was cut.
std::string cutText(std::string_view text, int lines, std::size_t bytes);

/// `prefix` before every line.
std::string indented(std::string_view text, std::string_view prefix);

}  // namespace muelle
