#pragma once
#include <cstddef>
#include <string_view>

namespace muelle {

/// One step of decoding UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 1;  ///< bytes read
  bool valid = false;      ///< false for a byte that begins no well-formed sequence; then length is 1
};

/// Decodes the code point at the front of `text`, which is not empty. Overlong forms, surrogates and values above
/// U+10FFFF are invalid (Unicode 15, table 3-7).
CodePoint decodeUtf8(std::string_view text);

/// True for characters that act or hide instead of being seen: controls, line and paragraph separators, marks that turn
/// the direction of text, zero-width characters, fillers, private use, code points that are no characters.
bool isTreacherous(char32_t codePoint);

/// Columns of a terminal that the code point takes: 0, 1 or 2.
int columns(char32_t codePoint);

/// Columns of a printable line.
int columns(std::string_view line);

}  // namespace muelle
