#pragma once
#include <cstddef>
#include <string_view>

namespace muelle::grader {

/// One step of decoding UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 1;  ///< bytes read
  bool valid = false;      ///< false for a byte that begins no well-formed sequence; then length is 1
};

/// Decodes the code point at the front of `text`, which is not empty. Overlong forms, surrogates and values above
/// U+10FFFF are invalid (Unicode 15, table 3-7).
CodePoint decodeUtf8(std::string_view text);

/// Columns of a terminal that the code point takes: 0, 1 or 2. The wide ranges are those of Unicode's EastAsianWidth
/// (W and F), to the block.
int columns(char32_t codePoint);

/// Columns of a printable line.
int columns(std::string_view line);

}  // namespace muelle::grader
